import { saveFile } from '../saveFile';

/**
 * Gives a file to the user by a save dialog, or as a download when there is none, or when the click was too long ago
 * for the browser to open it.
 * @throws errors of `saveFile`
 */
export async function download(blob: Blob, fileName: string, description: string): Promise<void> {
  const extensions = [fileName.slice(fileName.lastIndexOf('.'))];
  const options = { fileName, description, extensions, mimeTypes: [blob.type], id: 'farol-export' };
  try {
    await saveFile(blob, options);
  } catch (error) {
    const cause = error instanceof Error ? error.cause : null;
    if (!(cause instanceof DOMException && cause.name === 'SecurityError')) throw error;
    const link = document.createElement('a');
    link.download = fileName;
    link.href = URL.createObjectURL(blob);
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 30_000);
  }
}
