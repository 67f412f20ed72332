import { saveFile } from '../saveFile';

/**
 * Hands a file to the user: by the browser's dialog, or as a download where there is none, or where so long has gone by
 * since the click that the browser does not open it.
 * @throws what `saveFile` throws
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
