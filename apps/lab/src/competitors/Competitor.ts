import type { LightKind, Shading } from '../plan/lightKinds';
import type { StageScene } from '../stage/StageScene';

/** Canvas of a competitor that has been made ready to draw one case of a run. */
export interface Drawing {
  /** Context for waits and timer queries; null with WebGPU. */
  readonly gl: WebGL2RenderingContext | null;
  /** Draws the scene into the canvas. */
  render(): void;
  /**
   * Draws the first frame, for competitors that need more than `render` for it, such as a wait for shaders; resolves once
   * the picture is complete.
   */
  drawFirst?(): Promise<void>;
  /** Whether the competitor draws by the technique of its choice already; earlier frames are not timed. */
  isSettled?(): boolean;
  /** Checks for failures. @throws Error naming a failure while drawing, such as a shader that does not compile */
  check?(): void;
  /** Waits until everything is drawn; absent if reading a pixel of `gl` does that. */
  finish?(): Promise<void>;
  /** Called after lights were added to or removed from `StageScene.lights`. */
  lightsChanged?(): void;
  /** Called at the start of the timed drawing call, before `render`, after `StageScene.lights` have moved. */
  lightsMoved?(): void;
  /** Reads the picture drawn in this task, 8-bit sRGB, top row first; absent if a 2D canvas can read it. */
  readPicture?(): Promise<ImageData>;
  /** Number of lights that the competitor leaves out. */
  dropped?(): number;
  technique?(): { name: string; reason: string };
  targetBytes?(): number;
  /** Times of the passes in recent frames (ms). */
  passes?(): { kind: 'gpu' | 'cpu'; passes: { name: string; ms: number }[] } | null;
  /** Switches the timing of passes, which slows frames by timer queries. */
  setPassTimes?(on: boolean): void;
  /** Changes to another technique; absent if there is none. @returns a function that changes back */
  leaveTechnique?(): () => void;
  /** Frees the competitor's own resources; afterwards the stage frees the canvas's context. */
  dispose(): void;
}

/** Properties of a case for which a competitor may refuse it. */
export interface RefusableScene {
  /** Number of lights that have an object each. */
  readonly lights: number;
  readonly shadows: number;
  /** Kind of the moving lights. */
  readonly kind: LightKind;
  readonly shading: Shading;
}

/** A renderer or technique that draws cases. */
export interface Competitor {
  /** Key of the competitor, also in files and links. */
  readonly name: string;
  readonly label: string;
  /** Explanation of the competitor, one sentence. */
  readonly help: string;
  /** `farol`: by FarolRenderer; `three`: three's own renderers; `rival`: other engines, installed on demand. */
  readonly kind: 'farol' | 'three' | 'rival';
  /** Reason, a sentence, why the competitor cannot draw on this browser or device; null if it can. */
  unavailable(): Promise<string | null>;
  /** Reason, a sentence, why the competitor cannot draw a case, such as too many lights; null if it can. */
  refuses(scene: RefusableScene): string | null;
  /**
   * Opens the competitor for a case.
   * @param longest - limit of the first frame (ms)
   * @throws Error that names what failed
   */
  open(canvas: HTMLCanvasElement, scene: StageScene, signal: AbortSignal, longest: number): Promise<Drawing>;
}
