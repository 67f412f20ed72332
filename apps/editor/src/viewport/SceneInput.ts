import { type EngineKeyEvent, type EnginePointerEvent, InputRouter } from '@farol/engine';
import type { Camera } from 'three';
import type { EditorDocument } from '../model/EditorDocument';

/**
 * Sends pointer and keys to a scene that plays: to the object under the pointer always, to all components that follow the
 * pointer while a camera of the scene is looked through, keys while the picture has the focus and a component of the scene
 * listens to them. Escape gives the keys back to the editor, until the
 * picture is pressed or gets the focus anew.
 */
export class SceneInput {
  private readonly router: InputRouter;
  private isHeldBack = false;
  /** Keys that the scene knows to be held, by code. */
  private readonly held = new Set<string>();

  /**
   * @param surface - the canvas, as large as the view that is played in
   * @param getCamera - what the picture is seen through
   * @param isLookedThrough - whether a camera of the scene is looked through
   * @param changed - called when keys may go elsewhere than before
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

  /** Whether the pointer goes to the scene. */
  get hasPointer(): boolean {
    return this.document.simulation.isPlaying && this.isLookedThrough();
  }

  /** Whether keys would go to the scene, were the picture pressed. */
  get wantsKeys(): boolean {
    return this.document.simulation.isPlaying && this.document.scene.takesKeys;
  }

  /** Whether keys go to the scene. */
  get hasKeys(): boolean {
    return !this.isHeldBack && this.canvas.ownerDocument.activeElement === this.canvas && this.wantsKeys;
  }

  /** Keys go to the scene, if it wants any. */
  takeKeys(): void {
    this.canvas.focus({ preventScroll: true });
    this.taken();
  }

  /** Keys are the editor's again. */
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

  /** What the scene knows to be held is let go of, wherever keys go by then. */
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
