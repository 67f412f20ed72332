import {
  type FarolEffect,
  type Frame,
  FullscreenPass,
  PassTarget,
  setUnprojectUniforms,
  type TwinKind,
  unprojectUniforms,
} from '@farol/renderer/authoring';
import { FloatType, HalfFloatType, Matrix4, type Texture, Vector2 } from 'three';
import storedPosition from './storedPosition.glsl?raw';

export type PositionShow = 'stored' | 'rebuilt' | 'error';
const shows: readonly PositionShow[] = ['stored', 'rebuilt', 'error'];

/** Writes the view-space position of each pixel, as the first G-buffer of the thesis has it. */
const positionTwin: TwinKind = {
  key: 'thesis-position',
  chunks: () => [],
  properties: { toneMapped: false },
  patch(shader) {
    const end = shader.fragmentShader.lastIndexOf('}');
    shader.fragmentShader = `${shader.fragmentShader.slice(0, end)}gl_FragColor = vec4(-vViewPosition, 1.0);\n}`;
  },
};

/** Shows positions: stored in a target of their own, rebuilt from depth, or the error between the two. */
export class PositionView implements FarolEffect {
  readonly name = 'positions';
  show: PositionShow = 'rebuilt';
  /** Bits that depth is rounded to; 0: 32-bit floats as they are. */
  depthBits = 0;
  /** How many times the error is enlarged: 1 shows a metre as white. */
  gain = 1000;
  private half = false;
  private target = new PassTarget({ type: FloatType, depthTexture: true });
  private readonly pass = new FullscreenPass({
    program: 'positions',
    fragment: 'storedPosition',
    microShaders: { storedPosition },
    asThree: true,
    uniforms: {
      ...unprojectUniforms(),
      farol_offset: { value: new Vector2() },
      farol_size: { value: new Vector2() },
      thesis_stored: { value: null as Texture | null },
      thesis_depth: { value: null as Texture | null },
      thesis_viewInverse: { value: new Matrix4() },
      thesis_steps: { value: 0 },
      thesis_gain: { value: 1 },
      thesis_show: { value: 0 },
    },
  });

  get bytes(): number {
    return this.target.bytes;
  }

  /** Whether positions are stored as half floats; else as floats of 32 bits. */
  set halfFloats(half: boolean) {
    if (half === this.half) return;
    this.half = half;
    this.target.dispose();
    this.target = new PassTarget({ type: half ? HalfFloatType : FloatType, depthTexture: true });
  }

  end(frame: Frame): void {
    const { uniforms } = this.pass;
    const target = this.target.of(frame.width, frame.height);
    frame.bind(target);
    frame.clear(1, true);
    for (const item of frame.queue.opaque) if (item.route === 'split') frame.drawTwin(item, positionTwin);
    setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    uniforms.farol_size.value.set(frame.width, frame.height);
    uniforms.thesis_stored.value = target.texture;
    uniforms.thesis_depth.value = target.depthTexture;
    uniforms.thesis_viewInverse.value.copy(frame.camera.matrixWorld);
    uniforms.thesis_steps.value = this.depthBits === 0 ? 0 : 2 ** this.depthBits - 1;
    uniforms.thesis_gain.value = this.gain;
    uniforms.thesis_show.value = shows.indexOf(this.show);
    frame.bindTarget();
    this.pass.draw(frame);
  }

  dispose(): void {
    this.target.dispose();
    this.pass.dispose();
  }
}
