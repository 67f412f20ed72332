/** Inserts statements at the end of a shader's main(). */
export function beforeLastBrace(text: string, statements: string): string {
  const at = text.lastIndexOf('}');
  return `${text.slice(0, at)}\n${statements}\n${text.slice(at)}`;
}
