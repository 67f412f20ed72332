import { type IUniform, NoBlending, type Texture, Vector4 } from 'three';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { TextureAtlas } from '../atlas/TextureAtlas';
import { LEVEL_BORDER, levelBottom, levelLeft, levelSpan } from '../atlas/mipmapBlock';
import type { CookieSlot } from '../slots/CookieSlot';
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
    // three mirrors cube textures, except those of render targets
    uniforms.farol_cookieFlip.value = texture.isRenderTargetTexture ? 1 : -1;
    if (isProfile) this.drawProfile(cookie);
    else this.drawLevels(cookie, isCube);
    cookie.map.draw();
  }

  dispose(): void {
    this.images.dispose();
    this.cubes.dispose();
    this.profiles.dispose();
  }

  private drawLevels({ placement, levels = 1, textureWidth }: CookieSlot, isCube: boolean): void {
    const { uniforms, drawer } = this;
    const { faceWidth, faceHeight, region } = placement;
    const first = Math.max(0, Math.log2(textureWidth / faceWidth));
    const [across, up] = isCube ? [3, 2] : [1, 1];
    for (let level = 0; level < levels; level++) {
      const x = region!.x + levelLeft(faceWidth, level, across);
      const y = region!.y + levelBottom(faceHeight, level, up);
      const width = levelSpan(faceWidth, level);
      const height = levelSpan(faceHeight, level);
      const border = 2 * LEVEL_BORDER;
      uniforms.farol_cookieRegion.value.set(x + LEVEL_BORDER, y + LEVEL_BORDER, width - border, height - border);
      uniforms.farol_cookieLevel.value = first + level;
      drawer.drawPart(isCube ? this.cubes : this.images, x, y, across * width, up * height);
    }
  }

  private drawProfile({ placement }: CookieSlot): void {
    const { x, y, width, height } = placement.region!;
    this.uniforms.farol_cookieRegion.value.set(x, y, width, height);
    this.drawer.drawPart(this.profiles, x, y, width, height);
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
