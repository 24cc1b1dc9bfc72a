"""Problems: their codes, their places, their explanations, and the formats of reports."""
