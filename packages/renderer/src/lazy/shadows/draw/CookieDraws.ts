import { Camera, type CubeTexture, type IUniform, NoBlending, type Texture, Vector4, type WebGLRenderer } from 'three';
import type { MicroShaderRegistry } from '../../../microshaders';
import { FullscreenMesh } from '../../../gpu/FullscreenMesh';
import { PassMaterial } from '../../../gpu/PassMaterial';
import { COOKIE_BORDER, type CookieSlot } from '../slots/CookieSlot';
import type { DirectDraw } from '../DirectDraw';
import type { TextureAtlas } from '../atlas/TextureAtlas';

const rectangle = new Vector4();
const camera = new Camera();

/** Copies the images that lights throw into the atlas of colours. */
export class CookieDraws {
  private readonly triangle = new FullscreenMesh();
  private readonly uniforms = {
    farol_cookieImage: { value: null } as IUniform<Texture | null>,
    farol_cookieRegion: { value: new Vector4() },
    farol_cookieFlip: { value: 1 },
  };
  private flat: PassMaterial | null = null;
  private cube: PassMaterial | null = null;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly microshaders: MicroShaderRegistry,
  ) {}

  /** Copies an image into the image's region. */
  render(cookie: CookieSlot, atlas: TextureAtlas): void {
    const { webgl, uniforms } = this;
    const { texture, isCube } = cookie;
    const { region, faceWidth } = cookie.placement;
    const { x, y, width, height } = region!;
    const material = isCube ? (this.cube ??= this.make('cubes', true)) : (this.flat ??= this.make('images', false));
    uniforms.farol_cookieImage.value = texture;
    uniforms.farol_cookieRegion.value.set(
      x,
      y,
      isCube ? faceWidth : width,
      isCube ? faceWidth + 2 * COOKIE_BORDER : height,
    );
    // three keeps cube textures mirrored, all but those of render targets
    uniforms.farol_cookieFlip.value = (texture as CubeTexture).isRenderTargetTexture ? 1 : -1;
    material.uniformsNeedUpdate = true;
    webgl.setRenderTarget(atlas.target);
    webgl.state.viewport(rectangle.set(x, y, width, height));
    (webgl.renderBufferDirect as unknown as DirectDraw)(
      camera,
      null,
      this.triangle.geometry,
      material,
      this.triangle,
      null,
    );
    cookie.map.draw();
  }

  dispose(): void {
    this.flat?.dispose();
    this.cube?.dispose();
    this.flat = this.cube = null;
  }

  private make(name: string, cube: boolean): PassMaterial {
    return new PassMaterial(this.microshaders, {
      name: `Farol cookie ${name}`,
      vertex: ['fullscreen'],
      fragment: ['cookieRegion'],
      uniforms: this.uniforms,
      defines: cube ? { FAROL_CUBE: '' } : {},
      blending: NoBlending,
    });
  }
}
