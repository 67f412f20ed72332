import {
  AddEquation,
  BufferGeometry,
  CustomBlending,
  FloatType,
  HalfFloatType,
  type IUniform,
  type Mesh,
  NearestFilter,
  OneFactor,
  Points,
  RedFormat,
  type Texture,
  type TextureDataType,
  Vector2,
  WebGLRenderTarget,
} from 'three';
import type { Frame } from '../frame/Frame';
import { FullscreenPass } from '../gpu/FullscreenPass';
import { PassMaterial } from '../gpu/PassMaterial';

/** Number of cells of the view, plus one for lights without effect. */
const CELLS = 129;

/** Geometry shared by all renderers of the page; its draw range is set before each draw. */
const vertexless = /* @__PURE__ */ new BufferGeometry();

/**
 * Sorts the lights of fields by cells of the view, so that the 128 lights of a quad are near each other: a counting sort in four
 * draws. The lights of each cell in each row of 128 are counted; counts are summed over earlier rows, then over earlier cells;
 * then each light is drawn as a point at its sorted index, which is these sums plus the lights of its cell before it in its row.
 */
export class FieldOrder {
  private readonly counts = target(HalfFloatType);
  private readonly befores = target(FloatType);
  private readonly firsts = target(FloatType);
  private readonly order = target(FloatType);
  private readonly points = new Points(vertexless) as unknown as Mesh<BufferGeometry>;
  private readonly uniforms = {
    farol_fieldCells: { value: null as Texture | null },
    farol_fieldCountSize: { value: new Vector2() },
    farol_fieldCounts: { value: this.counts.texture },
    farol_fieldBefores: { value: this.befores.texture },
    farol_fieldFirsts: { value: this.firsts.texture },
    farol_fieldRows: { value: 0 },
  } satisfies Record<string, IUniform>;
  private readonly before = new FullscreenPass({
    program: 'lights before rows',
    fragment: 'fieldBefore',
    uniforms: { farol_fieldCounts: this.uniforms.farol_fieldCounts },
  });
  private readonly first = new FullscreenPass({
    program: 'lights before cells',
    fragment: 'fieldFirst',
    uniforms: {
      farol_fieldBefores: this.uniforms.farol_fieldBefores,
      farol_fieldRows: this.uniforms.farol_fieldRows,
    },
  });
  private isCompiled = false;
  private materials: { readonly count: PassMaterial; readonly place: PassMaterial } | null = null;

  constructor() {
    this.points.frustumCulled = false;
  }

  /** Indices of the lights in sorted order, 128 a row. */
  get texture(): Texture {
    return this.order.texture;
  }

  get bytes(): number {
    const { counts, befores, order } = this;
    return counts.width * counts.height * 2 + befores.width * befores.height * 4 + order.width * order.height * 4;
  }

  /** Compiles the programs, so that no later frame waits for them. */
  compile(frame: Frame): void {
    if (this.isCompiled) return;
    this.isCompiled = true;
    const { count, place } = (this.materials ??= this.make(frame));
    frame.bind(this.counts);
    frame.compileMesh(this.points, count);
    frame.bind(this.order);
    frame.compileMesh(this.points, place);
    this.before.compile(frame);
    this.first.compile(frame);
  }

  /** @param cells - cell of each light, 128 a row */
  draw(frame: Frame, cells: Texture, rows: number): void {
    const { uniforms, counts, befores, firsts, order, points } = this;
    this.isCompiled = true;
    const { count, place } = (this.materials ??= this.make(frame));
    fit(counts, CELLS, rows);
    fit(befores, CELLS, rows + 1);
    fit(firsts, CELLS, 1);
    fit(order, 128, rows);
    uniforms.farol_fieldCells.value = cells;
    uniforms.farol_fieldCountSize.value.set(CELLS, rows);
    uniforms.farol_fieldRows.value = rows;
    points.geometry.setDrawRange(0, rows * 128);
    frame.bind(counts);
    frame.clear(1, false);
    frame.drawMesh(points, count);
    this.before.drawTo(frame, befores);
    this.first.drawTo(frame, firsts);
    frame.bind(order);
    frame.drawMesh(points, place);
  }

  dispose(): void {
    for (const each of [this.counts, this.befores, this.firsts, this.order, this.before, this.first]) each.dispose();
    this.materials?.count.dispose();
    this.materials?.place.dispose();
    this.materials = null;
    this.isCompiled = false;
  }

  private make({ microshaders }: Frame): NonNullable<FieldOrder['materials']> {
    const { uniforms } = this;
    return {
      count: new PassMaterial(microshaders, {
        name: 'Farol lights in cells',
        vertex: ['fieldCount'],
        fragment: ['fieldOne'],
        uniforms: {
          farol_fieldCells: uniforms.farol_fieldCells,
          farol_fieldCountSize: uniforms.farol_fieldCountSize,
        },
        blending: CustomBlending,
        blendEquation: AddEquation,
        blendSrc: OneFactor,
        blendDst: OneFactor,
      }),
      place: new PassMaterial(microshaders, {
        name: 'Farol order of lights',
        vertex: ['fieldPlace'],
        fragment: ['fieldNumber'],
        uniforms: {
          farol_fieldCells: uniforms.farol_fieldCells,
          farol_fieldBefores: uniforms.farol_fieldBefores,
          farol_fieldFirsts: uniforms.farol_fieldFirsts,
          farol_fieldRows: uniforms.farol_fieldRows,
        },
      }),
    };
  }
}

function target(type: TextureDataType): WebGLRenderTarget {
  return new WebGLRenderTarget(1, 1, {
    format: RedFormat,
    type,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
}

/** Makes a target large enough for a size (texels), with spare rows when it grows, and limits drawing to that size. */
export function fit(target: WebGLRenderTarget, width: number, rows: number): void {
  if (target.width !== width || target.height < rows) target.setSize(width, rows === 1 ? 1 : Math.ceil(rows * 1.25));
  target.viewport.set(0, 0, width, rows);
}
