import { type CubeTexture, type IUniform, NoBlending, type Texture, Vector4 } from 'three';
import { FullscreenPass } from '../../../gpu/FullscreenPass';
import type { TextureAtlas } from '../atlas/TextureAtlas';
import { COOKIE_BORDER, type CookieSlot } from '../slots/CookieSlot';
import type { RegionDrawer } from './RegionDrawer';

/** Copies the images that lights throw, and their profiles, into the atlas of colours. */
export class CookieDraws {
  private readonly uniforms = {
    farol_cookieImage: { value: null } as IUniform<Texture | null>,
    farol_cookieRegion: { value: new Vector4() },
    farol_cookieFlip: { value: 1 },
  };
  private readonly images = this.make('cookie images', {});
  private readonly cubes = this.make('cookie cubes', { FAROL_CUBE: '' });
  private readonly profiles = this.make('light profiles', { FAROL_PROFILE: '' });

  constructor(private readonly drawer: RegionDrawer) {}

  /** Copies an image into the image's region. */
  render(cookie: CookieSlot, atlas: TextureAtlas): void {
    const { uniforms, drawer } = this;
    const { texture, isCube, isProfile } = cookie;
    const { region, faceWidth } = cookie.placement;
    const { x, y, width, height } = region!;
    uniforms.farol_cookieImage.value = texture;
    uniforms.farol_cookieRegion.value.set(
      x,
      y,
      isCube ? faceWidth : width,
      isCube ? faceWidth + 2 * COOKIE_BORDER : height,
    );
    // three keeps cube textures mirrored, all but those of render targets
    uniforms.farol_cookieFlip.value = (texture as CubeTexture).isRenderTargetTexture ? 1 : -1;
    drawer.bind(atlas.target!);
    drawer.drawPart(isCube ? this.cubes : isProfile ? this.profiles : this.images, x, y, width, height);
    cookie.map.draw();
  }

  dispose(): void {
    this.images.dispose();
    this.cubes.dispose();
    this.profiles.dispose();
  }

  private make(program: string, defines: Record<string, string>): FullscreenPass {
    const { uniforms } = this;
    return new FullscreenPass({
      program,
      fragment: 'cookieRegion',
      uniforms,
      defines,
      repeats: true,
      blending: NoBlending,
    });
  }
}
