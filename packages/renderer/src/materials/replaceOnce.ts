/**
 * Replaces the only place that has to be there.
 * @throws Error that names the marker, when this three.js has another text there
 */
export function replaceOnce(text: string, marker: string, by: string, where: string): string {
  if (!text.includes(marker)) {
    throw new Error(`Farol: "${marker}" not found in ${where}; this build of Farol is made for three 0.187.`);
  }
  return text.replace(marker, () => by);
}
