import { type EngineKeyEvent, type EnginePointerEvent, InputRouter } from '@farol/engine';
import type { Camera } from 'three';
import type { EditorDocument } from '../model/EditorDocument';

/**
 * Sends input to a playing scene: the pointer to the object under it, and, while the view of a scene's camera is shown,
 * to all components that follow the pointer; keys while the canvas has focus and a component listens to keys. Escape
 * returns the keys to the editor until the canvas is clicked or focused again.
 */
export class SceneInput {
  private readonly router: InputRouter;
  private isHeldBack = false;
  /** Codes of keys whose keydown was sent to the scene. */
  private readonly held = new Set<string>();

  /**
   * @param surface - the canvas, as large as the view that the scene is played in
   * @param getCamera - the camera of that view
   * @param isLookedThrough - whether the view is that of a scene's camera
   * @param changed - called when the receiver of keys may have changed
   */
  constructor(
    private readonly document: EditorDocument,
    private readonly canvas: HTMLCanvasElement,
    surface: HTMLCanvasElement,
    private readonly getCamera: () => Camera,
    private readonly isLookedThrough: () => boolean,
    private readonly changed: () => void,
  ) {
    this.router = new InputRouter(surface, window, {
      dispatchPointer: (event) => this.pointer(event),
      dispatchKey: (event) => this.mayPass(event) && document.scene.dispatchKey(event),
    });
    canvas.addEventListener('focus', this.taken);
    canvas.addEventListener('pointerdown', this.taken);
    canvas.addEventListener('blur', this.left);
  }

  get hasPointer(): boolean {
    return this.document.simulation.isPlaying && this.isLookedThrough();
  }

  /** Whether the scene would receive keys if the canvas had focus. */
  get wantsKeys(): boolean {
    return this.document.simulation.isPlaying && this.document.scene.takesKeys;
  }

  get hasKeys(): boolean {
    return !this.isHeldBack && this.canvas.ownerDocument.activeElement === this.canvas && this.wantsKeys;
  }

  /** Sends keys to the scene, if it uses any. */
  takeKeys(): void {
    this.canvas.focus({ preventScroll: true });
    this.taken();
  }

  /** Sends keys to the editor again. */
  giveKeysBack(): void {
    this.isHeldBack = true;
    this.left();
  }

  dispose(): void {
    this.canvas.removeEventListener('focus', this.taken);
    this.canvas.removeEventListener('pointerdown', this.taken);
    this.canvas.removeEventListener('blur', this.left);
    this.router.dispose();
  }

  private pointer(event: EnginePointerEvent): void {
    const { scene, simulation } = this.document;
    if (!simulation.isPlaying) return;
    scene.pointerCamera = this.getCamera();
    if (this.hasPointer) scene.dispatchPointer(event);
    else scene.dispatchObjectPointer(event);
  }

  /** Whether to send a key event. A keyup is always sent after its keydown, so that no key stays down. */
  private mayPass({ type, code }: EngineKeyEvent): boolean {
    if (type === 'up') return this.held.delete(code);
    if (this.hasKeys) this.held.add(code);
    return this.hasKeys;
  }

  private readonly taken = (): void => {
    this.isHeldBack = false;
    if (this.wantsKeys) this.changed();
  };

  private readonly left = (): void => {
    this.router.releaseKeys();
    if (this.wantsKeys) this.changed();
  };
}
