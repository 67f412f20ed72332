import {
  type Camera,
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
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import type { MicroShaderRegistry } from '../../../microshaders';
import { FullscreenMesh } from '../../../gpu/FullscreenMesh';
import { PassMaterial } from '../../../gpu/PassMaterial';
import type { ShadowMapDraws } from './ShadowMapDraws';
import type { DirectDraw } from '../DirectDraw';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { TextureAtlas } from '../atlas/TextureAtlas';

const rectangle = new Vector4();

/**
 * Draws variance shadow maps: a map's depths into a target of their own, then their mean and deviation, blurred down and across
 * as three does, into the map's region of the atlas.
 * @see Donnelly and Lauritzen 2006, Variance Shadow Maps
 */
export class MomentDraws {
  private readonly triangle = new FullscreenMesh();
  private readonly uniforms = {
    farol_momentSource: { value: null } as IUniform<Texture | null>,
    farol_momentRegion: { value: new Vector4() },
    farol_momentBlur: { value: [0, 0, 0] },
  };
  private depths: WebGLRenderTarget | null = null;
  private halves: WebGLRenderTarget | null = null;
  private down: PassMaterial | null = null;
  private across: PassMaterial | null = null;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly microshaders: MicroShaderRegistry,
    private readonly draws: ShadowMapDraws,
  ) {}

  get bytes(): number {
    return this.depths === null ? 0 : this.depths.width * this.depths.height * 9;
  }

  /** Draws the map of a light into the map's region. */
  render(slot: ShadowSlot, atlas: TextureAtlas): void {
    const { webgl } = this;
    const [face] = slot.faces;
    const { radius, blurSamples } = slot.light.shadow;
    this.prepareTargets(face.width, face.height);
    webgl.setRenderTarget(this.depths);
    this.draws.drawAlone(slot, face);
    const { down, across } = this.materials();
    this.uniforms.farol_momentBlur.value[0] = radius;
    this.uniforms.farol_momentBlur.value[1] = blurSamples;
    this.pass(this.halves!, this.depths!.depthTexture!, down, slot, 0, 0, face.camera);
    this.pass(atlas.target!, this.halves!.texture, across, slot, face.x, face.y, face.camera);
  }

  dispose(): void {
    this.depths?.depthTexture?.dispose();
    this.depths?.dispose();
    this.halves?.dispose();
    this.down?.dispose();
    this.across?.dispose();
    this.depths = this.halves = this.down = this.across = null;
  }

  private pass(
    target: WebGLRenderTarget,
    source: Texture,
    material: PassMaterial,
    slot: ShadowSlot,
    x: number,
    y: number,
    camera: Camera,
  ): void {
    const { webgl, uniforms } = this;
    uniforms.farol_momentSource.value = source;
    const { faceWidth, faceHeight } = slot.placement;
    uniforms.farol_momentRegion.value.set(x, y, faceWidth, faceHeight);
    material.uniformsNeedUpdate = true;
    webgl.setRenderTarget(target);
    webgl.state.viewport(rectangle.set(x, y, faceWidth, faceHeight));
    (webgl.renderBufferDirect as unknown as DirectDraw)(
      camera,
      null,
      this.triangle.geometry,
      material,
      this.triangle,
      null,
    );
  }

  private materials(): { down: PassMaterial; across: PassMaterial } {
    const make = (name: string, defines: Record<string, string>) =>
      new PassMaterial(this.microshaders, {
        name: `Farol shadow moments ${name}`,
        vertex: ['fullscreen'],
        fragment: ['shadowMoments'],
        uniforms: this.uniforms,
        defines,
        blending: NoBlending,
      });
    this.down ??= make('down', {});
    this.across ??= make('across', { FAROL_ACROSS: '' });
    return { down: this.down, across: this.across };
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
