/** Hands a file to the user as a download. */
export function saveFile(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.download = name;
  link.href = URL.createObjectURL(content);
  link.click();
  // the address is revoked later, since the browser reads the file after the click
  setTimeout(() => URL.revokeObjectURL(link.href), 30_000);
}
