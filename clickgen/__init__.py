"""clickgen: ladder logic as text for AutomationDirect CLICK PLCs."""
