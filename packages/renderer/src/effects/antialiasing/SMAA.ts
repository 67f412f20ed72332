import { HalfFloatType, RGFormat, type IUniform, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenMesh } from '../../gpu/FullscreenMesh';
import { PassMaterial } from '../../gpu/PassMaterial';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import displayTransfer from '../displayTransfer.glsl?raw';
import { EffectTarget } from '../EffectTarget';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import { Picture } from '../Picture';
import smaaBlend from './smaaBlend.glsl?raw';
import smaaEdges from './smaaEdges.glsl?raw';
import smaaWeights from './smaaWeights.glsl?raw';

const CHUNKS = { displayTransfer, smaaEdges, smaaWeights, smaaBlend };

/**
 * Enhanced subpixel morphological anti-aliasing of one picture (SMAA 1x): finds edges of luma, follows each to its ends (32
 * pixels to either side at most), and mixes the pixels along it by the area that a smooth edge would cover. Needs one
 * picture only: nothing ghosts. What is thinner than a pixel keeps flickering; `TAA` mends that. Without the diagonal
 * patterns of the paper's section 4.2. The area of a pattern is computed, not looked up, so there is no texture to load.
 * Works with every technique.
 * @see Jimenez, Echevarria, Sousa and Gutierrez 2012, SMAA: Enhanced Subpixel Morphological Antialiasing,
 *   https://www.iryoku.com/smaa/
 */
export class SMAA implements FarolEffect {
  readonly name = 'SMAA';
  readonly lacks = lacksFloatTargets;
  readonly takesPicture = true;
  private readonly edges = new EffectTarget({ format: RGFormat }, 2);
  private readonly weights = new EffectTarget({}, 4);
  private readonly output = new EffectTarget({ type: HalfFloatType }, 8);
  private readonly picture: IUniform<Texture | null> = { value: null };
  private readonly encoded = { value: false };
  private readonly edgeMap: IUniform<Texture | null> = { value: null };
  private readonly weightMap: IUniform<Texture | null> = { value: null };
  private readonly triangle = new FullscreenMesh();
  private steps: readonly PassMaterial[] | null = null;
  private shared: Picture | null = null;

  get bytes(): number {
    return this.edges.bytes + this.weights.bytes + this.output.bytes + (this.shared?.bytes ?? 0);
  }

  begin(frame: Frame): void {
    this.shared = Picture.of(frame);
    this.shared.begin(frame);
  }

  end(frame: Frame): void {
    const picture = this.shared!;
    const { width, height } = frame;
    this.steps ??= this.makeSteps(frame);
    const [edges, weights, blend] = this.steps;
    const edgeTarget = this.edges.of(width, height);
    const weightTarget = this.weights.of(width, height);
    const output = this.output.of(width, height);
    this.picture.value = picture.texture;
    this.encoded.value = picture.encoded;
    this.edgeMap.value = edgeTarget.texture;
    this.weightMap.value = weightTarget.texture;
    frame.bind(edgeTarget);
    frame.clear(1, false);
    frame.drawMesh(this.triangle, edges);
    frame.bind(weightTarget);
    frame.clear(1, false);
    frame.drawMesh(this.triangle, weights);
    frame.bind(output);
    frame.drawMesh(this.triangle, blend);
    picture.texture = output.texture;
    picture.encoded = false;
    picture.end(frame);
  }

  dispose(): void {
    for (const target of [this.edges, this.weights, this.output]) target.dispose();
    for (const step of this.steps ?? []) step.dispose();
    this.steps = null;
    this.shared?.dispose();
  }

  private makeSteps(frame: Frame): readonly PassMaterial[] {
    addMicroShaders(frame.microshaders, 'SMAA', CHUNKS);
    const step = (chunk: string, uniforms: Record<string, IUniform>) =>
      new PassMaterial(frame.microshaders, {
        name: `Farol ${chunk}`,
        vertex: ['fullscreen'],
        fragment: [chunk],
        uniforms,
      });
    const { picture: farol_picture, encoded: farol_encoded } = this;
    return [
      step('smaaEdges', { farol_picture, farol_encoded }),
      step('smaaWeights', { farol_edgeMap: this.edgeMap }),
      step('smaaBlend', { farol_picture, farol_encoded, farol_weightMap: this.weightMap }),
    ];
  }
}
