import type { MicroShader, MicroShaderRegistry } from '../../../microshaders';
import { parseMicroShader } from '../../../microshaders/parseMicroShader';
import { maskKindsChunk } from './maskKinds';

/** What shaders know of masks: it grows with what is met, and does not shrink, so that nothing compiles twice. */
export class MaskShaders {
  /** 0: no masks; 1: shadows and cookies; 2: layers too. */
  private known = 0;
  /** Those of `maskKinds` that shaders know, and those that this frame needs too. */
  private knownKinds = 0;
  private neededKinds = 0;
  private readonly before: MicroShader;

  constructor(private readonly microshaders: MicroShaderRegistry) {
    this.before = microshaders.get('lightMask')!;
  }

  /** @param kinds of `maskKinds` that a light of this frame needs */
  need(kinds: number): void {
    this.neededKinds |= kinds;
  }

  /** Has shaders know what this frame needs. */
  adapt(hasMasks: boolean, hasLayers: boolean): void {
    if (this.neededKinds !== this.knownKinds) {
      this.knownKinds = this.neededKinds;
      this.microshaders.swap('maskKinds', parseMicroShader('maskKinds', maskKindsChunk(this.knownKinds)));
    }
    const needed = hasLayers ? 2 : hasMasks ? 1 : 0;
    if (needed <= this.known) return;
    this.known = needed;
    this.microshaders.swap('lightMask', needed === 2 ? 'lightMaskLayers' : 'lightMaskOn');
  }

  /** Shaders know none again: there are no maps any more that they could look up. */
  dispose(): void {
    if (this.known > 0) this.microshaders.swap('lightMask', this.before);
    this.known = 0;
  }
}
