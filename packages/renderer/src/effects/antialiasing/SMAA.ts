import { HalfFloatType, LinearFilter, RGFormat, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import displayTransfer from '../../frame/displayTransfer.glsl?raw';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import type { FarolEffect } from '../../frame/FarolEffect';
import { Picture } from '../Picture';
import smaaBlend from './smaaBlend.glsl?raw';
import smaaEdges from './smaaEdges.glsl?raw';
import smaaWeights from './smaaWeights.glsl?raw';

const SIZE = ['farol_frameSize'];
const LINEAR = { minFilter: LinearFilter, magFilter: LinearFilter } as const;

/**
 * Enhanced subpixel morphological anti-aliasing of one picture (SMAA 1x): finds edges of luma, follows each to its ends
 * (32 pixels to either side at most), and mixes the pixels along it by the area that a smooth edge would cover. Only
 * one picture is used, so nothing ghosts. Details thinner than a pixel still flicker, unlike with `TAA`. The diagonal
 * patterns of the paper's section 4.2 are left out. Corners, and the ends and crossings of thin lines, stay sharp. The
 * areas of patterns are computed, so there is no texture to load. Works with every technique.
 * @see Jimenez, Echevarria, Sousa and Gutierrez 2012, SMAA: Enhanced Subpixel Morphological Antialiasing,
 *   https://www.iryoku.com/smaa/
 */
export class SMAA implements FarolEffect {
  readonly name = 'SMAA';
  readonly lacks = lacksFloatTargets;
  readonly takesPicture = true;
  readonly smoothsEdges = true;
  private readonly edges = new FullscreenPass({
    program: 'smaaEdges',
    fragment: 'smaaEdges',
    shared: SIZE,
    microShaders: { displayTransfer, smaaEdges },
    uniforms: { farol_picture: { value: null as Texture | null }, farol_encoded: { value: false } },
    target: { format: RGFormat, ...LINEAR },
  });
  private readonly weights = new FullscreenPass({
    program: 'smaaWeights',
    fragment: 'smaaWeights',
    shared: SIZE,
    microShaders: { smaaWeights },
    uniforms: { farol_edgeMap: { value: null as Texture | null } },
    target: LINEAR,
  });
  private readonly blend = new FullscreenPass({
    program: 'smaaBlend',
    fragment: 'smaaBlend',
    shared: SIZE,
    microShaders: { displayTransfer, smaaBlend },
    uniforms: { ...this.edges.uniforms, farol_weightMap: { value: null as Texture | null } },
    target: { type: HalfFloatType, ...LINEAR },
  });
  protected shared: Picture | null = null;

  get bytes(): number {
    return this.edges.bytes + this.weights.bytes + this.blend.bytes + (this.shared?.bytes ?? 0);
  }

  begin(frame: Frame): void {
    this.shared = Picture.of(frame);
    this.shared.begin(frame);
  }

  /** @param goesOn - whether more of the frame is drawn to the host's target afterwards */
  end(frame: Frame, goesOn = false): void {
    const picture = this.shared!;
    const { edges, weights, blend } = this;
    const { width, height } = frame;
    edges.uniforms.farol_picture.value = picture.texture;
    edges.uniforms.farol_encoded.value = picture.encoded;
    edges.bindOwn(frame, width, height);
    frame.clear(1, false);
    edges.draw(frame);
    weights.uniforms.farol_edgeMap.value = edges.texture;
    weights.bindOwn(frame, width, height);
    frame.clear(1, false);
    weights.draw(frame);
    blend.uniforms.farol_weightMap.value = weights.texture;
    picture.texture = blend.drawToOwn(frame, width, height).texture;
    picture.encoded = false;
    picture.end(frame, goesOn);
  }

  warmUp(frame: Frame): void {
    for (const pass of [this.edges, this.weights, this.blend]) pass.draw(frame);
    Picture.of(frame).warmUp(frame);
  }

  dispose(): void {
    for (const pass of [this.edges, this.weights, this.blend]) pass.dispose();
    this.shared?.dispose();
  }
}
