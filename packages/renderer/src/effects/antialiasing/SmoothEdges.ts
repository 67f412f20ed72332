import { Camera, LinearToneMapping, NoToneMapping, Scene, type WebGLRenderer } from 'three';
import type { ActiveEffects } from '../../frame/ActiveEffects';
import type { Frame } from '../../frame/Frame';
import { SMAA } from './SMAA';

/**
 * `FarolOptions.antialias`: SMAA of what a G-buffer has shaded, one sample a pixel. What is drawn over it afterwards, such as
 * lines, sprites and glass, is multisampled as stock three's, where no other effect needs the whole picture.
 */
export class SmoothEdges extends SMAA {
  readonly after = ['output'] as const;
  private effects: ActiveEffects | null = null;
  private withThis!: ActiveEffects;
  /** Whether three may draw to a buffer of its own in place of the canvas; null until it was asked. */
  private buffered: boolean | null = null;
  private isOn = false;

  /** Frames are drawn to the picture once it is known that the technique has a G-buffer. */
  override begin(): void {}

  picked(frame: Frame): void {
    // asked here: within three's render it cannot be
    if (frame.target === null) this.buffered ??= hasOutputBuffer(frame.webgl);
    this.isOn = !this.isLeftOut(frame);
    if (this.isOn) super.begin(frame);
  }

  render(frame: Frame): void {
    // what was drawn early has written depth and stencil that the target lacks
    if (this.isOn && frame.queue.early === 0 && this.shared!.isAlone) this.finish(frame, true);
  }

  override end(frame: Frame): void {
    if (this.isOn) this.finish(frame, false);
  }

  private finish(frame: Frame, goesOn: boolean): void {
    this.isOn = false;
    super.end(frame, goesOn);
  }

  /**
   * The effects of a frame with this one after them; as they are where one of them smooths edges, where the target has several
   * textures, and where effects of three's own are drawn from its output buffer.
   */
  addTo(effects: ActiveEffects, frame: Frame): ActiveEffects {
    if (this.isLeftOut(frame) || effects.all.some(smoothsEdges)) return effects;
    if (effects !== this.effects) {
      this.effects = effects;
      this.withThis = { ...effects, all: [...effects.all, this] };
    }
    return this.withThis;
  }

  private isLeftOut({ several, target }: Frame): boolean {
    return several || (target === null && this.buffered === true);
  }
}

const smoothsEdges = ({ smoothsEdges = false }: { readonly smoothsEdges?: boolean }): boolean => smoothsEdges;

const STOP = new Error('Farol: asked');

/** Whether the renderer was made with an `outputBufferType`, which it tells within `render` alone; nothing is drawn. */
function hasOutputBuffer(webgl: WebGLRenderer): boolean {
  const scene = new Scene();
  const { toneMapping } = webgl;
  const target = webgl.getRenderTarget();
  let has = false;
  scene.onBeforeRender = () => {
    has = webgl.toneMapping === NoToneMapping; // it tone maps when it copies the buffer to the canvas
    throw STOP; // before three clears
  };
  webgl.setRenderTarget(null);
  webgl.toneMapping = LinearToneMapping;
  try {
    webgl.render(scene, new Camera());
  } catch (error) {
    if (error !== STOP) throw error;
  } finally {
    webgl.toneMapping = toneMapping;
    webgl.setRenderTarget(target);
  }
  return has;
}
