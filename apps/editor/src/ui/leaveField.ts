/** Takes the focus out of a field, so that keys are hot keys again; a popup or a dialog keeps it. */
export function leaveField(field: HTMLElement | null): void {
  const popup = field?.closest<HTMLElement>('.popup, .dialog');
  if (popup) popup.focus();
  else field?.blur();
}
