import { NoBlending, Vector2, type Texture, type WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { FullscreenMesh } from '../../gpu/FullscreenMesh';
import type { Pass, Resource } from '../../frame/Pass';
import { PassMaterial } from '../../gpu/PassMaterial';
import { setUnprojectUniforms, unprojectUniforms } from '../../gpu/unprojectUniforms';
import { wordTarget } from '../../gpu/wordTarget';
import { TILE_SHIFT, type TileUniforms } from './tileUniforms';

/** What a tile's list may know of the depths in it: nothing, nearest and farthest, or also which of 32 slices hold any. */
export type TileDepthUse = 'none' | 'bounds' | 'slices';

/** Texels a row of a list texture; WebGL 2's least MAX_TEXTURE_SIZE. */
const ROW = 2048;
const LIGHTS_PER_QUAD = 128;
interface Materials {
  readonly coarse: PassMaterial;
  readonly fine: PassMaterial;
  readonly summary: PassMaterial;
  readonly depth: PassMaterial | null;
  readonly blocks: PassMaterial | null;
}

/**
 * Light lists of the screen's tiles, one bit a light, made on the GPU without compute: blocks of 4 × 4 tiles test all
 * lights, tiles test what their block kept, and a summary says which quads of 128 lights are not empty. No cap: a list has
 * room for every light.
 * @see Olsson and Assarsson 2011, Tiled Shading; Harada 2012, A 2.5D Culling for Forward+
 */
export class LightTilesPass implements Pass {
  readonly name = 'light lists';
  readonly reads: readonly Resource[];
  readonly writes = ['light-lists'] as const;
  private readonly coarse = wordTarget();
  private readonly fine = wordTarget();
  private readonly summary = wordTarget();
  private readonly depths = wordTarget();
  private readonly blocks = wordTarget();
  private readonly own = {
    ...unprojectUniforms(),
    farol_size: { value: new Vector2() },
    farol_beyond: { value: 1e38 },
    farol_coarseMask: { value: null as Texture | null },
    farol_tileDepth: { value: null as Texture | null },
    farol_sceneDepth: { value: null as Texture | null },
    farol_blocks: { value: null as Texture | null },
  };
  private readonly triangle = new FullscreenMesh();
  private materials: Materials | null = null;

  /** @param sceneDepth gives the depth texture of this frame, when depths are used */
  constructor(
    private readonly tiles: TileUniforms,
    private readonly use: TileDepthUse,
    private readonly sceneDepth: (() => Texture) | null = null,
    reads: readonly Resource[] = [],
  ) {
    this.reads = reads;
  }

  get bytes(): number {
    return [this.coarse, this.fine, this.summary, this.depths, this.blocks].reduce(
      (sum, t) => sum + t.width * t.height * 16,
      0,
    );
  }

  render(frame: Frame): void {
    const { lights } = frame;
    const x = Math.ceil(frame.width / (1 << TILE_SHIFT));
    const y = Math.ceil(frame.height / (1 << TILE_SHIFT));
    const quads = Math.max(1, Math.ceil(lights.bounded / LIGHTS_PER_QUAD));
    const pages = Math.ceil(quads / 128);
    this.setUniforms(frame, x, y, quads, pages);
    const materials = (this.materials ??= this.make(frame));
    this.giveStorage(frame);
    if (lights.bounded === 0) return;
    if (materials.depth !== null && materials.blocks !== null) {
      setSize(this.blocks, Math.ceil(frame.width / 4), Math.ceil(frame.height / 4));
      this.draw(frame, this.blocks, materials.blocks);
      setSize(this.depths, x, y);
      this.draw(frame, this.depths, materials.depth);
    }
    fit(this.coarse, Math.ceil(x / 4) * Math.ceil(y / 4) * quads);
    this.draw(frame, this.coarse, materials.coarse);
    fit(this.fine, x * y * quads);
    this.draw(frame, this.fine, materials.fine);
    // a list of one quad is its own summary
    if (quads === 1) return;
    fit(this.summary, x * y * pages);
    this.draw(frame, this.summary, materials.summary);
  }

  dispose(): void {
    for (const target of [this.coarse, this.fine, this.summary, this.depths, this.blocks]) target.dispose();
    const { materials } = this;
    materials?.coarse.dispose();
    materials?.fine.dispose();
    materials?.summary.dispose();
    materials?.depth?.dispose();
    materials?.blocks?.dispose();
    this.materials = null;
  }

  private setUniforms(frame: Frame, x: number, y: number, quads: number, pages: number): void {
    const { tiles, own } = this;
    const grid = tiles.farol_tiles.value;
    grid[1] = x;
    grid[2] = y;
    grid[3] = quads;
    const run = tiles.farol_tileRun.value;
    run[0] = frame.lights.firstBounded;
    run[1] = frame.lights.bounded;
    run[2] = pages;
    run[3] = frame.lights.plainQuads;
    tiles.farol_tileMask.value = this.fine.texture;
    tiles.farol_tileSummary.value = this.summary.texture;
    tiles.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    setUnprojectUniforms(own, frame.camera, frame.webgl);
    own.farol_size.value.set(frame.width, frame.height);
    own.farol_beyond.value = frame.queue.reachesFar ? Math.max(-1e30, frame.queue.farthest) : 1e38;
    own.farol_coarseMask.value = this.coarse.texture;
    own.farol_tileDepth.value = this.depths.texture;
    own.farol_blocks.value = this.blocks.texture;
    own.farol_sceneDepth.value = this.sceneDepth?.() ?? null;
  }

  /** A list that is not made this frame is bound all the same, so its texture must be there; also after a lost context. */
  private giveStorage(frame: Frame): void {
    for (const target of [this.fine, this.summary]) {
      const { __webglTexture } = frame.webgl.properties.get(target.texture) as { __webglTexture?: WebGLTexture };
      if (__webglTexture !== undefined) continue;
      fit(target, 1);
      frame.bind(target);
    }
  }

  private draw(frame: Frame, target: WebGLRenderTarget, material: PassMaterial): void {
    frame.bind(target);
    frame.drawMesh(this.triangle, material);
  }

  private make(frame: Frame): Materials {
    const { own } = this;
    const material = (name: string, fragment: string, defines: Record<string, string>) =>
      new PassMaterial(frame.microshaders, {
        name: `Farol ${name}`,
        vertex: ['fullscreen'],
        fragment: [fragment],
        // the lists that a pass writes are not among the textures that it reads
        uniforms: {
          farol_lightTable: frame.uniforms.farol_lightTable,
          farol_lightCounts: frame.uniforms.farol_lightCounts,
          farol_tiles: this.tiles.farol_tiles,
          farol_tileRun: this.tiles.farol_tileRun,
          farol_tileMask: this.tiles.farol_tileMask,
          ...own,
        },
        defines,
        blending: NoBlending,
      });
    const depth: Record<string, string> =
      this.use === 'none' ? {} : this.use === 'bounds' ? { FAROL_DEPTH: '' } : { FAROL_DEPTH: '', FAROL_SLICES: '' };
    const materials = {
      coarse: material('coarse light lists', 'tileMask', { FAROL_COARSE: '' }),
      fine: material('light lists', 'tileMask', depth),
      summary: material('light list summary', 'tileSummary', {}),
      depth: this.use === 'none' ? null : material('tile depths', 'tileDepth', {}),
      blocks: this.use === 'none' ? null : material('tile depth blocks', 'tileDepthBlocks', {}),
    };
    // all programs are linked now, each with a target of its kind
    this.giveStorage(frame);
    frame.bind(this.blocks);
    if (materials.blocks !== null) frame.compileMesh(this.triangle, materials.blocks);
    frame.bind(this.depths);
    if (materials.depth !== null) frame.compileMesh(this.triangle, materials.depth);
    frame.bind(this.coarse);
    frame.compileMesh(this.triangle, materials.coarse);
    frame.bind(this.fine);
    frame.compileMesh(this.triangle, materials.fine);
    frame.bind(this.summary);
    frame.compileMesh(this.triangle, materials.summary);
    return materials;
  }
}

function setSize(target: WebGLRenderTarget, width: number, height: number): void {
  if (target.width !== width || target.height !== height) target.setSize(width, height);
}

/** Gives a target room for so many texels, more than it needs when it grows, and draws to those alone. */
function fit(target: WebGLRenderTarget, texels: number): void {
  const rows = Math.ceil(texels / ROW);
  if (target.width !== ROW || target.height < rows) target.setSize(ROW, Math.ceil(rows * 1.25) + 4);
  target.viewport.set(0, 0, ROW, rows);
}
