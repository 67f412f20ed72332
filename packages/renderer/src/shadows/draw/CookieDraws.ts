import { type CubeTexture, type IUniform, NoBlending, type Texture, Vector4 } from 'three';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { TextureAtlas } from '../atlas/TextureAtlas';
import { LEVEL_BORDER, levelBottom } from '../atlas/mipmapBlock';
import { COOKIE_BORDER, type CookieSlot } from '../slots/CookieSlot';
import type { RegionDrawer } from './RegionDrawer';

/** Copies the textures that lights project (cookies), and photometric profiles, into the atlas of colours. */
export class CookieDraws {
  private readonly uniforms = {
    farol_cookieImage: { value: null } as IUniform<Texture | null>,
    farol_cookieRegion: { value: new Vector4() },
    farol_cookieFlip: { value: 1 },
    farol_cookieLevel: { value: 0 },
  };
  private readonly images = this.make('cookie images', { FAROL_IMAGE_KIND: '0' });
  private readonly cubes = this.make('cookie cubes', { FAROL_IMAGE_KIND: '1' });
  private readonly profiles = this.make('light profiles', { FAROL_IMAGE_KIND: '2' });

  constructor(private readonly drawer: RegionDrawer) {}

  /** Copies a cookie, or a photometric profile, into its region of the atlas. */
  render(cookie: CookieSlot, atlas: TextureAtlas): void {
    const { uniforms, drawer } = this;
    const { texture, isCube, isProfile } = cookie;
    uniforms.farol_cookieImage.value = texture;
    drawer.bind(atlas.target!);
    if (isCube || isProfile) this.drawWhole(cookie);
    else this.drawLevels(cookie);
    cookie.map.draw();
  }

  dispose(): void {
    this.images.dispose();
    this.cubes.dispose();
    this.profiles.dispose();
  }

  private drawLevels({ placement, levels = 1, textureWidth }: CookieSlot): void {
    const { uniforms, drawer } = this;
    const { faceWidth, faceHeight, region } = placement;
    const first = Math.max(0, Math.log2(textureWidth / faceWidth));
    for (let level = 0; level < levels; level++) {
      const width = Math.max(1, faceWidth >> level);
      const height = Math.max(1, faceHeight >> level);
      const x = region!.x + (level === 0 ? 0 : faceWidth + 2 * LEVEL_BORDER);
      const y = region!.y + levelBottom(faceHeight, level);
      uniforms.farol_cookieRegion.value.set(x + LEVEL_BORDER, y + LEVEL_BORDER, width, height);
      uniforms.farol_cookieLevel.value = first + level;
      drawer.drawPart(this.images, x, y, width + 2 * LEVEL_BORDER, height + 2 * LEVEL_BORDER);
    }
  }

  private drawWhole({ texture, isCube, placement }: CookieSlot): void {
    const { uniforms, drawer } = this;
    const { region, faceWidth } = placement;
    const { x, y, width, height } = region!;
    uniforms.farol_cookieRegion.value.set(
      x,
      y,
      isCube ? faceWidth : width,
      isCube ? faceWidth + 2 * COOKIE_BORDER : height,
    );
    // three keeps cube textures mirrored, all but those of render targets
    uniforms.farol_cookieFlip.value = (texture as CubeTexture).isRenderTargetTexture ? 1 : -1;
    drawer.drawPart(isCube ? this.cubes : this.profiles, x, y, width, height);
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
