/** Removes the focus from a field, so that shortcuts work again; within a popup or dialog the focus stays inside. */
export function leaveField(field: HTMLElement | null): void {
  const popup = field?.closest<HTMLElement>('.popup, .dialog');
  if (popup) popup.focus();
  else field?.blur();
}
