import type { EditorHandle } from '../editor/editor';
import type { Driven, Point } from './driven';

declare global {
  interface Window {
    editor: EditorHandle;
    /** Files that the page has saved, by name; left by {@link openEditor}. */
    savedFiles: Map<string, Blob>;
  }
}

/** Opens the editor with its empty scene, and keeps what it downloads in the page. */
export async function openEditor(driven: Driven): Promise<void> {
  await driven.open(`${process.env.FAROL_EDITOR_URL}?scene=empty`);
  await driven.until(() => 'editor' in window);
  await driven.evaluate(() => window.editor.ready);
  await driven.until(() => window.editor.viewport.canvas.isConnected);
  await driven.evaluate(() => {
    window.savedFiles = new Map();
    const blobs = new Map<string, Blob>();
    const address = URL.createObjectURL.bind(URL);
    URL.createObjectURL = (blob: Blob) => {
      const url = address(blob);
      blobs.set(url, blob);
      return url;
    };
    const click = HTMLAnchorElement.prototype.click;
    HTMLAnchorElement.prototype.click = function (this: HTMLAnchorElement) {
      const blob = blobs.get(this.href);
      if (!this.download || !blob) return click.call(this);
      window.savedFiles.set(this.download, blob);
      this.dispatchEvent(new MouseEvent('click'));
    };
  });
}

/** Waits for a saved file whose name ends with `end`. */
export async function savedFile(driven: Driven, end: string): Promise<Buffer> {
  await driven.until((end) => [...window.savedFiles.keys()].some((name) => name.endsWith(end)), end);
  const base64 = await driven.evaluate(async (end) => {
    const [, blob] = [...window.savedFiles].find(([name]) => name.endsWith(end))!;
    const bytes = new Uint8Array(await blob.arrayBuffer());
    const letters: string[] = [];
    for (let i = 0; i < bytes.length; i += 8192) letters.push(String.fromCharCode(...bytes.subarray(i, i + 8192)));
    return btoa(letters.join(''));
  }, end);
  return Buffer.from(base64, 'base64');
}

/** Page position (CSS pixels) of an object, and of the handle that moves it along x. */
export const pointsOf = (driven: Driven, object: string): Promise<{ middle: Point; handle: Point }> =>
  driven.evaluate((name) => {
    const { viewport, document } = window.editor;
    viewport.renderNow();
    const { object3D } = document.scene.find(name)!;
    const place = object3D.getWorldPosition(object3D.position.clone());
    const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
    const pointAt = (x: number): Point => {
      const at = place.clone();
      at.x += x;
      at.project(viewport.camera as never);
      return { x: Math.round(left + ((at.x + 1) / 2) * width), y: Math.round(top + ((1 - at.y) / 2) * height) };
    };
    // where three draws it: 0.85 of a sixth of the picture's height, in perspective
    const eye = place.clone().setFromMatrixPosition(viewport.camera.matrixWorld);
    const { fov } = viewport.camera as unknown as { fov: number };
    const size = (place.distanceTo(eye) * Math.min(1.9 * Math.tan((Math.PI * fov) / 360), 7) * 0.85) / 4;
    return { middle: pointAt(0), handle: pointAt(size * 0.4) };
  }, object);
