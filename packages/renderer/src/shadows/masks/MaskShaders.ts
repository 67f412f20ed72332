import type { MicroShader, MicroShaderRegistry } from '../../microshaders';
import { parseMicroShader } from '../../microshaders/parseMicroShader';
import { imageSamplersChunk } from './imageSamplersChunk';
import { maskFeatures, maskFeaturesChunk } from './maskFeatures';

/**
 * Features of shadows, cookies and layers that shaders are compiled with. Features are only added, as lights need them,
 * so that nothing is compiled twice.
 */
export class MaskShaders {
  /** Variant of the chunk `lightMask`. 0: no shadows, cookies or layers; 1: shadows and cookies; 2: layers too. */
  private level = 0;
  /** Kinds of masks that the shaders have code for, as bits of `maskFeatures`. */
  private features = 0;
  private neededFeatures = 0;
  private readonly originalChunk: MicroShader;

  /** @param images - number of samplers for the textures that lights project */
  constructor(
    private readonly microshaders: MicroShaderRegistry,
    private readonly images: number,
  ) {
    this.originalChunk = microshaders.get('lightMask')!;
  }

  /** Adds features that a light of the frame needs. @param features - bits of `maskFeatures` */
  need(features: number): void {
    this.neededFeatures |= features;
  }

  /** Adapts shaders to the frame's masks: to features that `need` has added, and to whether there are masks and layers. */
  adapt(hasMasks: boolean, hasLayers: boolean): void {
    if (this.neededFeatures !== this.features) {
      this.features = this.neededFeatures;
      const samplers = (this.features & maskFeatures.images) !== 0 ? this.images : 0;
      this.swap('maskFeatures', maskFeaturesChunk(this.features));
      this.swap('imageSamplers', imageSamplersChunk(samplers));
    }
    const needed = hasLayers ? 2 : hasMasks ? 1 : 0;
    if (needed <= this.level) return;
    this.level = needed;
    this.microshaders.swap('lightMask', needed === 2 ? 'lightMaskLayers' : 'lightMaskOn');
  }

  private swap(name: string, text: string): void {
    this.microshaders.swap(name, parseMicroShader(name, text));
  }

  /** Removes all code for masks from shaders, when the maps are disposed. */
  dispose(): void {
    if (this.level > 0) this.microshaders.swap('lightMask', this.originalChunk);
    this.level = 0;
  }
}
