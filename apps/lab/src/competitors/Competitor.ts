import type { LightKind, Shading } from '../plan/lightKinds';
import type { StageScene } from '../stage/StageScene';

/** A competitor as it draws one case. */
export interface Drawing {
  /** The context whose frames are waited for and timed; null with WebGPU. */
  readonly gl: WebGL2RenderingContext | null;
  /** Draws the scene as it is into the canvas. */
  render(): void;
  /**
   * Draws the first frame, timed as such, where that takes more than `render` (shaders that compile meanwhile); resolves
   * once the whole picture was drawn.
   */
  drawFirst?(): Promise<void>;
  /** Whether it draws by the technique that it chose for the scene; until then frames are drawn that nobody times. */
  isSettled?(): boolean;
  /** @throws Error that names what went wrong while drawing, such as a shader that does not compile */
  check?(): void;
  /** Waits until what was drawn is done, where that is not the reading of a pixel of `gl`. */
  finish?(): Promise<void>;
  /** Called after lights were added to or removed from `StageScene.lights`. */
  lightsChanged?(): void;
  /** Called before a frame whose lights moved (positions in `StageScene.lights`), inside the timed call. */
  lightsMoved?(): void;
  /** Reads the picture that was drawn in this task, where a 2D canvas cannot: all of it, 8-bit sRGB, top row first. */
  readPicture?(): Promise<ImageData>;
  /** Lights that are left out. */
  dropped?(): number;
  technique?(): { name: string; reason: string };
  targetBytes?(): number;
  /** Times of the passes of the last frames (ms). */
  passes?(): { kind: 'gpu' | 'cpu'; passes: { name: string; ms: number }[] } | null;
  /** Switches the times of the passes on or off: they cost timer queries. */
  setPassTimes?(on: boolean): void;
  /** Chooses another technique for the next frames, where there are some. @returns what chooses the own one again */
  leaveTechnique?(): () => void;
  /** Frees what was made; the stage ends the context itself. */
  dispose(): void;
}

/** What of a case a competitor may be unable to draw. */
export interface RefusableScene {
  /** Lights that are objects of their own. */
  readonly lights: number;
  readonly shadows: number;
  /** What the moving lights are. */
  readonly kind: LightKind;
  readonly shading: Shading;
}

/** Who can draw a case. */
export interface Competitor {
  /** Key, also in files and links. */
  readonly name: string;
  readonly label: string;
  /** What it is and when it wins, a sentence. */
  readonly help: string;
  /** `farol`: by FarolRenderer; `three`: three's own renderers; `rival`: other engines, installed on demand. */
  readonly kind: 'farol' | 'three' | 'rival';
  /** Why it cannot draw here, as a sentence; null when it can. */
  unavailable(): Promise<string | null>;
  /**
   * Why it cannot draw a case, as a sentence (too many lights for its uniforms, shadows or kinds of lights it has not);
   * null when it can.
   */
  refuses(scene: RefusableScene): string | null;
  /**
   * @param longest - time that a first frame may take (ms)
   * @throws Error that names what failed
   */
  open(canvas: HTMLCanvasElement, scene: StageScene, signal: AbortSignal, longest: number): Promise<Drawing>;
}
