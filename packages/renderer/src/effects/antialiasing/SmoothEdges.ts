import type { ActiveEffects } from '../../frame/ActiveEffects';
import type { Frame } from '../../frame/Frame';
import { hasOutputBuffer } from '../../three/hasOutputBuffer';
import { SMAA } from './SMAA';

/**
 * Implements `FarolOptions.antialias`: SMAA of the pixels shaded from a G-buffer, one sample each. Later draws, such as lines,
 * sprites and glass, are multisampled as in stock three, unless another effect needs the whole picture.
 */
export class SmoothEdges extends SMAA {
  readonly after = ['output'] as const;
  private effects: ActiveEffects | null = null;
  private withThis!: ActiveEffects;
  /** Whether three draws to an output buffer in place of the canvas; null until tested. */
  private buffered: boolean | null = null;
  private isOn = false;

  /** Does nothing: `picked` redirects the frame, if the technique has a G-buffer. */
  override begin(): void {}

  picked(frame: Frame): void {
    // the drawing buffer's format is read here, since reading it within three's `render` fails
    if (frame.target === null) this.buffered ??= hasOutputBuffer(frame.webgl);
    this.isOn = !this.isLeftOut(frame);
    if (this.isOn) super.begin(frame);
  }

  render(frame: Frame): void {
    // items drawn before the G-buffer's have written depth and stencil, which the host's target lacks
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
   * Effects of a frame with this one appended; unchanged if one of them smooths edges, if the target has several textures, or if
   * three's own effects read its output buffer.
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
