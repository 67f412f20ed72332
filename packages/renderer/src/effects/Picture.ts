import {
  AlwaysDepth,
  CustomBlending,
  LessEqualDepth,
  NoBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  Vector2,
  type Texture,
  type WebGLRenderTarget,
} from 'three';
import type { Frame } from '../frame/Frame';
import { FrameRedirect, isEncoded } from '../frame/FrameRedirect';
import { FullscreenPass } from '../gpu/FullscreenPass';
import picturePresent from './picturePresent.glsl?raw';
import displayTransfer from '../frame/displayTransfer.glsl?raw';

/** Picture of each renderer, keyed by the renderer's cache of twins (materials with Farol's programs). */
const pictures = new WeakMap<Frame['twins'], Picture>();

/**
 * The picture of a frame in a target of Farol's own, with depth as a texture, for effects that need the whole picture. `begin`
 * redirects all draws to it, with the host's target's output (for the canvas, tone mapped and encoded). When each effect that
 * called `begin` has called `end`, the picture is written to the host's target with its depth.
 */
export class Picture {
  /** Target that the frame draws to, from `begin` on. */
  target!: WebGLRenderTarget;
  /** Current picture: `target`'s texture, or the result of an effect. */
  texture!: Texture;
  /** Whether `texture` is encoded for the display (sRGB's transfer function), not linear. */
  encoded = false;
  private users = 0;
  private toDisplay = false;
  private readonly redirect = new FrameRedirect('Farol picture', false);
  private readonly present = new FullscreenPass({
    program: 'picture',
    fragment: 'picturePresent',
    microShaders: { displayTransfer, picturePresent },
    uniforms: {
      farol_picture: { value: null as Texture | null },
      farol_pictureDepth: { value: null as Texture | null },
      farol_offset: { value: new Vector2() },
      farol_encode: { value: false },
    },
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
    depthTest: true,
    depthWrite: true,
  });

  /** The one picture of a renderer, shared by its effects. */
  static of(frame: Frame): Picture {
    let picture = pictures.get(frame.twins);
    if (picture === undefined) pictures.set(frame.twins, (picture = new Picture()));
    return picture;
  }

  get bytes(): number {
    return this.redirect.bytes;
  }

  /** Redirects the frame's draws to this picture. Each effect that calls `begin` calls `end` too. */
  begin(frame: Frame): void {
    if (this.redirect.owns(frame.target)) {
      this.users++;
      return;
    }
    this.users = 1; // set to 1, not incremented: an exception in the last frame may have left some
    this.target = this.redirect.targetFor(frame);
    this.redirect.begin(frame, this.target, frame.width, frame.height);
    this.texture = this.target.texture;
    this.toDisplay = isEncoded(this.target.texture.colorSpace);
    this.encoded = this.toDisplay;
  }

  /**
   * Whether the rest of a frame can be drawn directly to the host's target: a single effect uses the picture, and a
   * pixel has the same coordinates in the picture and in the host's target.
   */
  get isAlone(): boolean {
    return this.users === 1 && this.redirect.viewport.x === 0 && this.redirect.viewport.y === 0;
  }

  /** Whether a single effect uses the picture at this point: its result is the finished picture. */
  get isLast(): boolean {
    return this.users === 1;
  }

  /**
   * Ends the use of the picture by an effect; the last effect to end writes the picture to the host's target.
   * @param goesOn - whether more of the frame is drawn to the host's target afterwards
   */
  end(frame: Frame, goesOn = false): void {
    if (--this.users > 0) return;
    const { webgl } = frame;
    const { replaces } = this.redirect;
    this.redirect.end(frame);
    const { uniforms } = this.present;
    uniforms.farol_picture.value = this.texture;
    uniforms.farol_pictureDepth.value = this.target.depthTexture;
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    uniforms.farol_encode.value = this.toDisplay && !this.encoded;
    const material = this.present.material(frame);
    // the picture replaces the host's earlier content where it was cleared, else it is blended over that content
    material.blending = replaces ? NoBlending : CustomBlending;
    material.depthFunc = replaces ? AlwaysDepth : LessEqualDepth;
    frame.bindTarget();
    // three has cleared the stencil of the picture's target only; the host's is cleared here
    if (goesOn && replaces && webgl.autoClearStencil) webgl.clear(false, false, true);
    const samples = goesOn && frame.wantsSampleDepths;
    material.depthWrite = !samples;
    if (samples) frame.clear(0, true);
    this.present.draw(frame);
    if (samples) frame.drawSampleDepths();
  }

  /** Compiles the program that writes the picture to the host's target. */
  warmUp(frame: Frame): void {
    this.present.draw(frame);
  }

  dispose(): void {
    this.redirect.dispose();
    this.present.dispose();
  }
}
