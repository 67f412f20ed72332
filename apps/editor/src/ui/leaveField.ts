/** Removes the focus from a field, so that shortcuts work again; a popup or dialog around the field gets it. */
export function leaveField(field: HTMLElement | null): void {
  const popup = field?.closest<HTMLElement>('.popup, .dialog');
  if (popup) popup.focus();
  else field?.blur();
}
