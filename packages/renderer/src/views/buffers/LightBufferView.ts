import { type IUniform, type Texture, Vector2 } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { BufferView, ShownView } from './BufferView';
import { Panels } from './Panels';
import { problems } from './problems';

/** Labels of the light buffer's sums, by `farol_sum` in lightBufferView.glsl. */
const SUMS = [
  { label: 'Diffuse light' },
  { label: 'Specular light' },
  { label: 'Specular light at grazing angles' },
  { label: 'Ambient light of lamps, area lights' },
] as const;

const texture = (): IUniform<Texture | null> => ({ value: null });

/** Shows the sums of the light buffer, one in each quarter. */
export class LightBufferView implements BufferView {
  private readonly panels = new Panels();
  private readonly pass = new FullscreenPass({
    program: 'light buffer view',
    fragment: 'lightBufferView',
    asThree: true,
    toneMapped: true,
    repeats: true,
    uniforms: {
      farol_sums0: texture(),
      farol_sums1: texture(),
      farol_sums2: texture(),
      farol_sums3: texture(),
      farol_size: { value: new Vector2() },
      farol_panel: { value: this.panels.panel },
      farol_sum: { value: 0 },
    },
  });

  show(frame: Frame, info: ShownView): string | null {
    const buffer = frame.resources.find('light-buffer');
    if (buffer === undefined) return problems.lightBuffer;
    const { panels, pass } = this;
    const { uniforms } = pass;
    for (const name of ['farol_sums0', 'farol_sums1', 'farol_sums2', 'farol_sums3'] as const)
      uniforms[name].value = buffer.uniforms[name].value;
    uniforms.farol_size.value.copy(buffer.uniforms.farol_size.value);
    frame.bindTarget();
    panels.begin();
    for (let i = 0; i < SUMS.length; i++) {
      panels.next(frame, (i & 1) / 2, (i >> 1) / 2, 0.5, 0.5).label = SUMS[i].label;
      uniforms.farol_sum.value = i;
      pass.draw(frame);
    }
    panels.end(frame, info);
    return null;
  }

  dispose(): void {
    this.pass.dispose();
    this.panels.dispose();
  }
}
