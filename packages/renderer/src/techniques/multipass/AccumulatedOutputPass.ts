import { CustomBlending, NoBlending, OneFactor, OneMinusSrcAlphaFactor, Vector2, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { setUnprojectUniforms, unprojectUniforms } from '../../gpu/unprojectUniforms';
import * as chunks from './chunks';
import { OutputPass } from '../../passes/output/OutputPass';

const accumulatedUniforms = () => ({
  ...unprojectUniforms(),
  farol_accumulated: { value: null as Texture | null },
  farol_accumulatedDepth: { value: null as Texture | null },
  farol_offset: { value: new Vector2() },
  farol_size: { value: new Vector2() },
});

/** Writes the sums of multipass lighting to the host's target. */
export class AccumulatedOutputPass extends OutputPass<ReturnType<typeof accumulatedUniforms>> {
  readonly microShaders = { ...chunks };
  readonly reads = ['accumulated-light', 'overdraw'] as const;

  constructor() {
    super({
      program: 'multipass output',
      fragment: 'accumulatedOutput',
      uniforms: accumulatedUniforms(),
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
    });
  }

  protected read(frame: Frame): void {
    const { uniforms } = this;
    const { texture, depth, hasFog } = frame.resources.get('accumulated-light');
    uniforms.farol_accumulated.value = texture;
    uniforms.farol_accumulatedDepth.value = depth;
    uniforms.farol_size.value.set(frame.width, frame.height);
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
    const material = this.material(frame);
    if (material.fog === hasFog) {
      material.fog = !hasFog;
      material.needsUpdate = true;
    }
    // at multisampled edges, samples of earlier draws show through
    material.blending = frame.samples > 0 ? CustomBlending : NoBlending;
  }
}
