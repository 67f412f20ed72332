import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { gbufferUniforms, setGBufferUniforms } from '../../passes/gbuffer/gbufferUniforms';
import type { SurfaceViewPass } from '../SurfaceViewPass';
import type { BufferView } from './BufferView';
import { problems } from './problems';

/** Shows fog between the eye and each surface: the light that it adds, or its transmittance. */
export class FogView implements BufferView {
  private readonly pass = new FullscreenPass({
    program: 'fog view',
    fragment: 'fogView',
    shared: 'all',
    asThree: true,
    toneMapped: true,
    repeats: true,
    uniforms: { ...gbufferUniforms(), farol_view: { value: 0 } },
  });

  /** @param surfaces - pass that draws depths @param view - `farol_view` of fogView.glsl */
  constructor(
    private readonly surfaces: SurfaceViewPass,
    private readonly view: 0 | 1,
  ) {}

  show(frame: Frame): string | null {
    if (frame.resources.find('froxels') === undefined) return problems.fog;
    const { uniforms } = this.pass;
    setGBufferUniforms(uniforms, this.surfaces.fillPlainly(frame), frame);
    uniforms.farol_view.value = this.view;
    frame.bindTarget();
    const space = frame.uniforms.farol_mediaSpace.value;
    const { x, y, z, w } = frame.viewport;
    space[0] = x;
    space[1] = y;
    space[2] = 1 / z;
    space[3] = 1 / w;
    space[7] = 1;
    this.pass.draw(frame);
    space[7] = 0;
    return null;
  }

  dispose(): void {
    this.pass.dispose();
  }
}
