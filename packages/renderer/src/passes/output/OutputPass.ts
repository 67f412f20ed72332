import { AlwaysDepth, LessEqualDepth } from 'three';
import type { Frame } from '../../frame/Frame';
import type { Pass, Resource } from '../../frame/Pass';
import { isCountView } from '../../frame/views';
import { FullscreenPass, type FullscreenPassOptions, type Uniforms } from '../../gpu/FullscreenPass';
import { OUTPUT_COUNTS, OUTPUT_FINAL, OUTPUT_LIGHTING, outputUniforms, type OutputUniforms } from './outputUniforms';

/**
 * Writes the result of earlier passes to the host's target, with depth, as three would have drawn it: later draws, by Farol or
 * the host, find the state that stock three would leave. In heat-map views it draws the counts.
 */
export abstract class OutputPass<U extends Uniforms> extends FullscreenPass<OutputUniforms & U> implements Pass {
  readonly name = 'output';
  abstract readonly reads: readonly Resource[];
  readonly writes = ['target', 'output'] as const;

  /** @param options - options of the pass; `uniforms` are added to `OutputUniforms` */
  constructor(options: Omit<FullscreenPassOptions<U>, 'asThree'> & { readonly uniforms: U }) {
    super({
      shared: 'all',
      toneMapped: true,
      depthTest: true,
      depthWrite: true,
      ...options,
      asThree: true,
      uniforms: { ...outputUniforms(), ...options.uniforms },
    });
  }

  /** Sets the uniforms to the resources that the pass reads. */
  protected abstract read(frame: Frame): void;

  render(frame: Frame): void {
    const { view, resources } = frame;
    this.read(frame);
    const uniforms: OutputUniforms = this.uniforms;
    uniforms.farol_view.value = isCountView(view)
      ? OUTPUT_COUNTS
      : view === 'lighting'
        ? OUTPUT_LIGHTING
        : OUTPUT_FINAL;
    uniforms.farol_overdrawMap.value = resources.find('overdraw') ?? null;
    const material = this.material(frame);
    const samples = frame.wantsSampleDepths;
    const covers = samples || isCountView(view) || frame.fills === 'every-pixel';
    material.depthFunc = covers ? AlwaysDepth : LessEqualDepth;
    material.depthWrite = !samples;
    frame.bindTarget();
    this.draw(frame);
    if (samples) frame.drawSampleDepths();
  }
}
