import {
  AlwaysDepth,
  CustomBlending,
  HalfFloatType,
  LessEqualDepth,
  NoBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  type Texture,
  Vector2,
  type WebGLRenderTarget,
} from 'three';
import type { Frame } from '../../frame/Frame';
import { isEncoded } from '../../frame/FrameRedirect';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import displayTransfer from '../../frame/displayTransfer.glsl?raw';
import easu from './easu.glsl?raw';
import finer from './finer.glsl?raw';
import perceptual from './perceptual.glsl?raw';
import rcas from './rcas.glsl?raw';

/** Options of passes that write colour and depth to the host's target, blended over its pixels or replacing them. */
const TO_HOST = {
  shared: ['farol_frameSize'],
  blendSrc: OneFactor,
  blendDst: OneMinusSrcAlphaFactor,
  depthTest: true,
  depthWrite: true,
} as const;

/** Enlarges a picture to the host's target, along its edges, and sharpens it: AMD's FidelityFX Super Resolution 1.0. */
export class Enlargement {
  private readonly shared = {
    farol_offset: { value: new Vector2() },
    farol_scaling: { value: new Vector2() },
    farol_isLinear: { value: false },
  };
  private readonly easu = new FullscreenPass({
    program: 'EASU',
    fragment: 'easu',
    microShaders: { perceptual, easu },
    shared: ['farol_frameSize'],
    uniforms: {
      ...this.shared,
      farol_offset: { value: new Vector2() },
      farol_picture: { value: null as Texture | null },
    },
    // half floats: RCAS would sharpen the steps of colours rounded to bytes
    target: { type: HalfFloatType },
  });
  private readonly depth = {
    farol_pictureDepth: { value: null as Texture | null },
    farol_largeSize: { value: new Vector2() },
  };
  private readonly rcas = new FullscreenPass({
    ...TO_HOST,
    program: 'RCAS',
    fragment: 'rcas',
    microShaders: { perceptual, rcas },
    uniforms: {
      ...this.shared,
      ...this.depth,
      farol_large: { value: null as Texture | null },
      farol_sharpness: { value: 0 },
    },
  });
  private readonly finer = new FullscreenPass({
    ...TO_HOST,
    program: 'finer picture',
    fragment: 'finer',
    microShaders: { displayTransfer, finer },
    uniforms: {
      ...this.shared,
      ...this.depth,
      farol_finer: { value: null as Texture | null },
      farol_finerSize: { value: new Vector2() },
    },
  });

  get bytes(): number {
    return this.easu.bytes;
  }

  /**
   * Draws to the frame's target and viewport.
   * @param small - target that holds the picture, in its viewport
   * @param replaces - whether the picture replaces the target's pixels; else it is blended over them, behind nearer depths
   */
  draw(frame: Frame, small: WebGLRenderTarget, sharpness: number, replaces: boolean): void {
    const { shared, depth, easu, rcas, finer } = this;
    const { viewport, width, height } = frame;
    const { colorSpace } = small.texture;
    shared.farol_offset.value.set(viewport.x, viewport.y);
    shared.farol_scaling.value.set(small.viewport.z / width, small.viewport.w / height);
    shared.farol_isLinear.value = !isEncoded(colorSpace);
    depth.farol_pictureDepth.value = small.depthTexture;
    depth.farol_largeSize.value.set(width, height);
    const pass = frame.finer === null ? rcas : finer;
    if (frame.finer === null) {
      easu.uniforms.farol_picture.value = small.texture;
      rcas.uniforms.farol_large.value = easu.drawToOwn(frame, width, height).texture;
      rcas.uniforms.farol_sharpness.value = sharpness;
    } else {
      finer.uniforms.farol_finer.value = frame.finer.texture;
      finer.uniforms.farol_finerSize.value.set(frame.finer.viewport.z, frame.finer.viewport.w);
    }
    const material = pass.material(frame);
    material.blending = replaces ? NoBlending : CustomBlending;
    material.depthFunc = replaces ? AlwaysDepth : LessEqualDepth;
    frame.bindTarget();
    pass.draw(frame);
  }

  dispose(): void {
    for (const pass of [this.easu, this.rcas, this.finer]) pass.dispose();
  }
}
