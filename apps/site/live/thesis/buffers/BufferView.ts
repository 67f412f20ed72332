import {
  type FarolEffect,
  type Frame,
  FullscreenPass,
  gbufferUniforms,
  type LightBuffer,
  setGBufferUniforms,
  setUnprojectUniforms,
  unprojectUniforms,
} from '@farol/renderer/authoring';
import { FloatType, Matrix4, type PerspectiveCamera, type Texture, Vector2 } from 'three';
import bufferView from './bufferView.glsl?raw';
import thinBufferView from './thinBufferView.glsl?raw';
import tileBounds from './tileBounds.glsl?raw';

/** Buffers of techniques with a G-buffer, in the order of `thesis_show` in bufferView.glsl. */
const full = [
  'albedo',
  'normal',
  'depth',
  'position',
  'specular',
  'shininess',
  'ambient',
  'model',
  'lighting',
  'tile-depth',
  'slices',
] as const;
/** Buffers of light pre-pass and inferred lighting, in the order of `thesis_show` in thinBufferView.glsl. */
const thin = ['thin-depth', 'thin-normal', 'thin-lobe', 'thin-object', 'light-diffuse', 'light-specular'] as const;

export type BufferName = (typeof full)[number] | (typeof thin)[number];

/** Shows a buffer of the frame in place of its picture, or of the right part of it. */
export class BufferView implements FarolEffect {
  readonly name = 'buffer view';
  readonly bytes = 0;
  /** The buffer; null for the picture. One that the technique does not have leaves the picture as it is. */
  show: BufferName | null = null;
  /** Share of the picture's width from which on the buffer is shown, 0 to 1. */
  from = 0;
  /** Channel that is shown alone, 0 to 2; -1 for all. */
  channel = -1;
  /** Distances (m) that are shown black and white. */
  readonly depths = new Vector2(2, 20);
  private readonly uniforms = {
    ...gbufferUniforms(),
    thesis_depths: { value: this.depths },
    thesis_viewInverse: { value: new Matrix4() },
    thesis_texture: { value: null as Texture | null },
    thesis_show: { value: 0 },
    thesis_from: { value: 0 },
    thesis_channel: { value: -1 },
  };
  private readonly surface = new FullscreenPass({
    program: 'buffer view',
    fragment: 'bufferView',
    microShaders: { bufferView },
    asThree: true,
    shared: 'all',
    uniforms: this.uniforms,
  });
  private readonly bounds = new FullscreenPass({
    program: 'tile bounds',
    fragment: 'tileBounds',
    microShaders: { tileBounds },
    uniforms: { ...unprojectUniforms(), thesis_sceneDepth: { value: null as Texture | null } },
    target: { type: FloatType },
  });
  private thin: ReturnType<typeof thinPass> | null = null;

  end(frame: Frame): void {
    const { show } = this;
    if (show === null) return;
    const at = (full as readonly string[]).indexOf(show);
    if (at < 0) this.drawThin(frame, (thin as readonly string[]).indexOf(show));
    else this.drawFull(frame, at);
  }

  dispose(): void {
    this.surface.dispose();
    this.bounds.dispose();
    this.thin?.dispose();
    this.thin = null;
  }

  private drawFull(frame: Frame, at: number): void {
    const { uniforms, bounds } = this;
    const gbuffer = frame.resources.find('gbuffer');
    const depth = gbuffer?.depth ?? frame.resources.find('scene-depth');
    if (depth === undefined) return;
    if (gbuffer !== undefined) setGBufferUniforms(uniforms, gbuffer, frame);
    else {
      uniforms.farol_gDepth.value = depth;
      setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
      uniforms.farol_size.value.set(frame.width, frame.height);
    }
    uniforms.thesis_texture.value = frame.resources.find('lighting') ?? null;
    if (full[at] === 'tile-depth') {
      bounds.uniforms.thesis_sceneDepth.value = depth;
      setUnprojectUniforms(bounds.uniforms, frame.camera, frame.webgl);
      const tiles = bounds.drawToOwn(frame, Math.ceil(frame.width / 16), Math.ceil(frame.height / 16));
      uniforms.thesis_texture.value = tiles.texture;
    }
    uniforms.thesis_show.value = at;
    uniforms.thesis_from.value = this.from * frame.width;
    uniforms.thesis_channel.value = this.channel;
    uniforms.thesis_viewInverse.value.copy((frame.camera as PerspectiveCamera).matrixWorld);
    frame.bindTarget();
    this.surface.draw(frame);
  }

  private drawThin(frame: Frame, at: number): void {
    const lights = frame.resources.find('light-buffer');
    if (lights === undefined) return;
    const pass = (this.thin ??= thinPass(lights, this.depths));
    const { target } = frame.resources.get('thin-gbuffer');
    pass.uniforms.thesis_show.value = at;
    pass.uniforms.thesis_scale.value = target.width / frame.width;
    pass.uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    frame.bindTarget();
    pass.draw(frame);
  }
}

function thinPass({ uniforms }: LightBuffer, depths: Vector2) {
  return new FullscreenPass({
    program: 'thin buffer view',
    fragment: 'thinBufferView',
    microShaders: { thinBufferView },
    asThree: true,
    uniforms: {
      ...uniforms,
      farol_offset: { value: new Vector2() },
      thesis_depths: { value: depths },
      thesis_show: { value: 0 },
      thesis_scale: { value: 1 },
    },
  });
}
