import type { Page } from '@playwright/test';

/** Dropped files: bytes or text by file name. */
export type Dropped = Record<string, Uint8Array | string>;

/** Drops files on the window, as a user would from the desktop. */
export async function drop(page: Page, files: Dropped): Promise<void> {
  const bytes = Object.entries(files).map(([name, content]) => [name, Buffer.from(content).toString('base64')]);
  await page.evaluate(async (files) => {
    const transfer = new DataTransfer();
    for (const [name, text] of files) {
      transfer.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], name));
    }
    for (const type of ['dragenter', 'dragover', 'drop']) {
      document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer: transfer }));
    }
  }, bytes);
}
