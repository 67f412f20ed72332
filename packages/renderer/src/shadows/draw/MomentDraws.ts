import {
  DepthTexture,
  FloatType,
  HalfFloatType,
  type IUniform,
  LinearFilter,
  NearestFilter,
  NoBlending,
  RedFormat,
  RGFormat,
  type Texture,
  Vector2,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { RegionDrawer } from './RegionDrawer';
import type { ShadowMapDraws } from './ShadowMapDraws';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TextureAtlas } from '../atlas/TextureAtlas';

/**
 * Draws variance shadow maps: a map's depths into a separate target, then their mean and deviation, blurred along columns and
 * rows as in three, into the map's region of the atlas.
 * @see Donnelly and Lauritzen 2006, Variance Shadow Maps
 */
export class MomentDraws {
  private readonly uniforms = {
    farol_momentSource: { value: null } as IUniform<Texture | null>,
    farol_momentRegion: { value: new Vector4() },
    farol_momentBlur: { value: new Vector2() },
  };
  private depths: WebGLRenderTarget | null = null;
  private halves: WebGLRenderTarget | null = null;
  private readonly down = this.make('shadow moments down', 'shadowMomentsDown');
  private readonly across = this.make('shadow moments across', 'shadowMomentsAcross');

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly drawer: RegionDrawer,
    private readonly draws: ShadowMapDraws,
  ) {}

  get bytes(): number {
    return this.depths === null ? 0 : this.depths.width * this.depths.height * 9;
  }

  /** Draws a light's map, blurs it, and writes its moments to the map's region. */
  render(slot: ShadowSlot, atlas: TextureAtlas): void {
    const { webgl } = this;
    const [face] = slot.faces;
    const { radius, blurSamples } = slot.light.shadow;
    this.prepareTargets(face.width, face.height);
    webgl.setRenderTarget(this.depths);
    this.draws.drawAlone(slot, face);
    this.uniforms.farol_momentBlur.value.set(radius, blurSamples);
    this.blur(this.halves!, this.depths!.depthTexture!, this.down, slot, 0, 0);
    this.blur(atlas.target!, this.halves!.texture, this.across, slot, face.x, face.y);
  }

  dispose(): void {
    this.depths?.depthTexture?.dispose();
    this.depths?.dispose();
    this.halves?.dispose();
    this.down.dispose();
    this.across.dispose();
    this.depths = this.halves = null;
  }

  private blur(
    target: WebGLRenderTarget,
    source: Texture,
    pass: FullscreenPass,
    { placement: { faceWidth, faceHeight } }: ShadowSlot,
    x: number,
    y: number,
  ): void {
    const { drawer, uniforms } = this;
    uniforms.farol_momentSource.value = source;
    uniforms.farol_momentRegion.value.set(x, y, faceWidth, faceHeight);
    drawer.bind(target);
    drawer.drawPart(pass, x, y, faceWidth, faceHeight);
  }

  private make(program: string, fragment: string): FullscreenPass {
    const { uniforms } = this;
    return new FullscreenPass({ program, fragment, uniforms, repeats: true, blending: NoBlending });
  }

  /** Makes both targets as large as the largest map so far. */
  private prepareTargets(width: number, height: number): void {
    if (this.depths === null || this.halves === null) {
      const depthTexture = new DepthTexture(width, height, FloatType);
      depthTexture.minFilter = depthTexture.magFilter = NearestFilter;
      this.depths = new WebGLRenderTarget(width, height, {
        format: RedFormat,
        minFilter: NearestFilter,
        magFilter: NearestFilter,
        depthTexture,
      });
      this.halves = new WebGLRenderTarget(width, height, {
        format: RGFormat,
        type: HalfFloatType,
        minFilter: LinearFilter,
        magFilter: LinearFilter,
        depthBuffer: false,
      });
    }
    if (this.depths.width >= width && this.depths.height >= height) return;
    const w = Math.max(width, this.depths.width);
    const h = Math.max(height, this.depths.height);
    this.depths.setSize(w, h);
    this.halves.setSize(w, h);
  }
}
