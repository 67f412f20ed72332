import {
  BackSide,
  type BufferGeometry,
  type Camera,
  DoubleSide,
  FrontSide,
  type Material,
  Matrix4,
  type Mesh,
  NoBlending,
  Object3D,
  PerspectiveCamera,
  type Side,
  Vector3,
  type WebGLRenderer,
} from 'three';
import type { GeometryGroup } from '../../../../frame/RenderItem';
import type { MicroShaderRegistry } from '../../../../microshaders';
import { PassMaterial } from '../../../../gpu/PassMaterial';
import { shadowSideOf } from '../CasterMaterials';
import { cubeFacesOf } from '../../slots/cubeFacesOf';
import { moveBox } from '../moveBox';
import { isBeyond } from '../../slots/reach';
import type { Caster, ShadowCasters } from '../ShadowCasters';
import type { Draw } from '../../draw/ShadowMapDraws';
import type { ShadowFace } from '../../slots/ShadowFace';
import type { ShadowSlot } from '../../slots/ShadowSlot';
import { CasterGeometry } from './CasterGeometry';
import { CasterMatrices } from './CasterMatrices';
import { addCubeRuns, addMapRuns } from './clusterRuns';
import { CLUSTERS_PER_GROUP } from './ClusterOrder';
import { uniteBoxes } from '../uniteBoxes';
import { isMergeable } from './isMergeable';
import type { MergedCaster } from './MergedCaster';
import { MergedMesh } from './MergedMesh';

/** Frames for which a caster that came to look otherwise is not merged. */
const SETTLED = 30;
/** Triangles merged at most: some 22 bytes each on the GPU, and as much beside it. */
const MOST_TRIANGLES = 2_000_000;
/** Triangles looked at a frame while casters are made ready, so that no frame is late. */
const BUDGET = 150_000;
/** Triangles of casters that are gone, below which they are kept. */
const FEW_GONE = 65_536;
/** Frames between looks at who is gone, and for which they are kept. */
const SWEEP = 256;
/** Spacing of the places that matrices count from (m): nearer ones keep more of their digits. */
const GRID = 128;

/** What three keeps of a material. */
interface MaterialState {
  __version?: number;
  currentProgram?: { program: WebGLProgram };
}

const view = new Matrix4();
const camera = new PerspectiveCamera(); // three changes it where depth is reversed
/** None of the indices, and so that three does no more than compile. */
const NOTHING: GeometryGroup = { start: 0, count: 0 };
const NOT_EVEN_A_DRAW: GeometryGroup = { start: 1, count: -1 };

/** As many objects as a block of matrices holds. */
interface Page {
  readonly mesh: MergedMesh;
  readonly matrices: CasterMatrices;
  objects: number;
}

/**
 * The casters of a scene whose triangles lie in one buffer, in small clusters, so that a face of a shadow map draws all that
 * it sees of them in one call. Casters come to it in time, some a frame; those that it does not hold are drawn one by one.
 */
export class MergedCasters {
  private readonly pages: Page[] = [];
  private readonly capacity: number;
  private readonly material: PassMaterial;
  private readonly geometries = new WeakMap<BufferGeometry, CasterGeometry>();
  private members: MergedCaster[] = [];
  /** Those that cast shadows in this frame. */
  private readonly present: MergedCaster[] = [];
  /** Their boxes, 6 numbers each, so that the many looks at them need no others. */
  private presentBoxes = new Float64Array(6 * 64);
  private readonly waiting: Caster[] = [];
  private readonly origin = new Vector3();
  private readonly gl: WebGL2RenderingContext;
  private multiDraw: WEBGL_multi_draw | null = null;
  private readonly viewFloats = new Float32Array(16);
  private viewLocation: WebGLUniformLocation | null = null;
  /** Page and side that three has bound for draws, -1 if something else. */
  private bound = -1;
  private gone = 0;
  private triangles = 0;

  constructor(
    private readonly webgl: WebGLRenderer,
    registry: MicroShaderRegistry,
  ) {
    this.gl = webgl.getContext() as WebGL2RenderingContext;
    this.capacity = CasterMatrices.capacity(webgl);
    this.material = new PassMaterial(registry, {
      name: 'Farol shadow casters',
      vertex: ['mergedCaster'],
      fragment: ['mergedCasterDepth'],
      uniforms: {},
      defines: { FAROL_CASTERS: `${this.capacity}` },
      blending: NoBlending,
      depthTest: true,
      depthWrite: true,
    });
    this.material.colorWrite = false;
    this.addPage();
  }

  /** Adds what stands in for the triangles in three's traversal, so that they are sent. */
  addStands(stands: Object3D[]): void {
    for (const { mesh } of this.pages) stands.push(mesh.stand);
  }

  /**
   * Begins a frame in which maps may be drawn: follows the camera, and takes up some of the casters that wait.
   * @param casters of the scene
   * @param loose gets those of them that it does not hold
   */
  begin(view: Camera, { list, count, frame }: ShadowCasters, loose: Caster[]): void {
    this.moveOrigin(view);
    if (frame % SWEEP === 0)
      for (const { caster } of this.members) if (frame - caster.frame > SWEEP) this.letGo(caster);
    if (this.gone > FEW_GONE && this.gone * 2 > this.triangles) this.startAnew();
    for (let i = 0; i < count; i++) this.find(list[i]);
    for (let left = BUDGET; left > 0 && this.waiting.length > 0;) {
      const caster = this.waiting[this.waiting.length - 1];
      left -= this.makeReady(caster);
    }
    this.present.length = 0;
    for (let i = 0; i < count; i++) {
      const merged = this.find(list[i]);
      if (merged !== null) this.present.push(merged);
      else loose.push(list[i]);
    }
    const { present } = this;
    if (present.length * 6 > this.presentBoxes.length) this.presentBoxes = new Float64Array(present.length * 12);
    for (let i = 0; i < present.length; i++) this.presentBoxes.set(present[i].caster.box, i * 6);
  }

  /** A caster as it is held, null while it is not. */
  find(caster: Caster): MergedCaster | null {
    const { merged } = caster;
    if (merged !== null && this.isSame(merged)) return merged;
    if (merged !== null) this.letGo(caster);
    if (caster.waits === caster.look) return null;
    // what changes in frame after frame is drawn by itself
    if (caster.look > 1 && caster.frame - caster.looked < SETTLED) return null;
    caster.waits = caster.look;
    if (caster.hasBox && isMergeable(caster.object)) this.waiting.push(caster);
    return null;
  }

  /** Whether a caster is still what was merged: one that looks otherwise, by its material say, may have the same triangles. */
  private isSame(merged: MergedCaster): boolean {
    const { caster, geometry } = merged;
    const { object, hasBox, look } = caster;
    if (!hasBox || !geometry.isCurrent || object.onAfterShadow !== Object3D.prototype.onAfterShadow) return false;
    if (merged.look === look) return true;
    if (!geometry.isOf((object as Mesh).geometry) || !isMergeable(object)) return false;
    merged.look = look;
    return true;
  }

  private letGo(caster: Caster): void {
    if (caster.merged === null) return;
    this.gone += caster.merged.geometry.triangles;
    caster.merged = null;
    caster.waits = -1;
  }

  /** Has each face of a light's map draw the clusters that it sees, in the part of it that is drawn. */
  addTo(slot: ShadowSlot, bothSides: boolean): void {
    const { isCube, reach, layers, drawnFaces } = slot;
    const { present, presentBoxes: boxes } = this;
    for (let i = 0; i < present.length; i++) {
      if (isCube ? (cubeFacesOf(boxes, i * 6, reach) & drawnFaces) === 0 : isBeyond(reach, boxes, i * 6)) continue;
      const merged = present[i];
      const { object } = merged.caster;
      if ((object.layers.mask & layers) === 0) continue;
      this.follow(merged);
      const side = seenSide(shadowSideOf((object as Mesh).material as Material, bothSides), merged.isMirrored);
      if (isCube) addCubeRuns(slot, merged, side);
      else addMapRuns(slot, merged, side);
    }
  }

  /** Sends what draws need, and has the program there that they are made with. */
  prepare(): void {
    const { gl, pages, material } = this;
    const state = this.webgl.properties.get(material) as MaterialState;
    if (state.__version !== material.version) {
      // new, edited, or gone with a lost context
      for (const { matrices } of pages) matrices.lose();
      this.show(pages[0].mesh, NOT_EVEN_A_DRAW);
      const { extensions } = this.webgl;
      const name = 'WEBGL_multi_draw';
      this.multiDraw = extensions.has(name) ? (extensions.get(name) as unknown as WEBGL_multi_draw) : null;
      const { program } = state.currentProgram!;
      pages[0].matrices.attach(program);
      this.viewLocation = gl.getUniformLocation(program, 'farol_casterView');
    }
    for (const { matrices } of pages) matrices.send();
    this.interrupt();
  }

  /** Something else was drawn: what three has bound is not known any more. */
  interrupt(): void {
    this.bound = -1;
  }

  /** Draws what a face sees into its part of the target. */
  draw(face: ShadowFace): void {
    const { gl, webgl, viewFloats } = this;
    const { x, y, z } = this.origin;
    let viewed = false;
    for (let page = 0; page < this.pages.length; page++) {
      for (let side = 0; side < 3; side++) {
        const { count, starts, counts } = face.runs(page, side);
        if (count === 0) continue;
        if (this.bound !== page * 3 + side) this.bind(page, side as Side);
        if (!viewed) {
          const { projectionMatrix, matrixWorldInverse } = face.camera;
          const e = view.multiplyMatrices(projectionMatrix, matrixWorldInverse).elements;
          for (let i = 0; i < 12; i++) viewFloats[i] = e[i];
          for (let i = 0; i < 4; i++) viewFloats[12 + i] = e[i] * x + e[4 + i] * y + e[8 + i] * z + e[12 + i];
          gl.uniformMatrix4fv(this.viewLocation, false, viewFloats);
          viewed = true;
        }
        let indices = 0;
        for (let i = 0; i < count; i++) indices += counts[i];
        if (this.multiDraw !== null) {
          this.multiDraw.multiDrawElementsWEBGL(gl.TRIANGLES, counts, 0, gl.UNSIGNED_INT, starts, 0, count);
        } else {
          for (let i = 0; i < count; i++) gl.drawElements(gl.TRIANGLES, counts[i], gl.UNSIGNED_INT, starts[i]);
        }
        webgl.info.update(indices, gl.TRIANGLES, 1);
      }
    }
  }

  dispose(): void {
    this.letAllGo();
    for (const { mesh, matrices } of this.pages) {
      mesh.dispose();
      matrices.dispose();
    }
    this.material.dispose();
  }

  /** Has three bind all that draws of a page need; then they need but say what they draw. */
  private bind(page: number, side: Side): void {
    const { mesh, matrices } = this.pages[page];
    matrices.bind();
    this.material.side = side;
    this.show(mesh, NOTHING);
    this.bound = page * 3 + side;
  }

  private show({ mesh }: MergedMesh, part: GeometryGroup): void {
    (this.webgl.renderBufferDirect as unknown as Draw)(camera, null, mesh.geometry, this.material, mesh, part);
  }

  private addPage(): Page {
    const page = { mesh: new MergedMesh(this.material), matrices: new CasterMatrices(this.webgl), objects: 0 };
    this.pages.push(page);
    return page;
  }

  /** @returns triangles looked at */
  private makeReady(caster: Caster): number {
    if (caster.waits !== caster.look || caster.merged !== null) {
      this.waiting.pop();
      return 1;
    }
    const { geometry: source } = caster.object as Mesh;
    let geometry = this.geometries.get(source);
    if (geometry === undefined) this.geometries.set(source, (geometry = new CasterGeometry(source)));
    const room = MOST_TRIANGLES - this.triangles;
    if (!geometry.isCurrent || !geometry.isSound || geometry.triangles > room) {
      this.waiting.pop(); // what changes is drawn by itself
      return 1;
    }
    if (!geometry.isDone) return geometry.step(BUDGET);
    this.waiting.pop();
    this.add(caster, geometry);
    return geometry.triangles;
  }

  private add(caster: Caster, geometry: CasterGeometry): void {
    let page = this.pages.findIndex(({ objects }) => objects < this.capacity);
    if (page < 0) {
      page = this.pages.length;
      this.addPage();
    }
    const { mesh, objects: object } = this.pages[page];
    this.pages[page].objects++;
    this.triangles += geometry.triangles;
    const merged: MergedCaster = {
      caster,
      geometry,
      page,
      object,
      first: mesh.add(geometry.positions, geometry.index, object),
      look: caster.look,
      boxes: new Float64Array(geometry.boxes.length),
      groups: new Float64Array(Math.ceil(geometry.boxes.length / 6 / CLUSTERS_PER_GROUP) * 6),
      place: -1,
      isMirrored: false,
    };
    caster.merged = merged;
    this.members.push(merged);
  }

  /** Moves the boxes, and the matrix in the block, to where the caster is. */
  follow(merged: MergedCaster): void {
    const { caster, boxes, geometry, page, object } = merged;
    if (merged.place === caster.place) return;
    merged.place = caster.place;
    const { matrixWorld } = caster.object;
    for (let at = 0; at < boxes.length; at += 6) moveBox(geometry.boxes, at, matrixWorld, boxes, at);
    for (let group = 0; group < merged.groups.length; group += 6) {
      uniteBoxes(
        boxes,
        group * CLUSTERS_PER_GROUP,
        Math.min(boxes.length, (group + 6) * CLUSTERS_PER_GROUP),
        merged.groups,
        group,
      );
    }
    merged.isMirrored = matrixWorld.determinantAffine() < 0;
    this.pages[page].matrices.set(object, matrixWorld, this.origin);
  }

  /** Matrices count from a place near the camera, so that far from the world's origin they keep their digits. */
  private moveOrigin(view: Camera): void {
    const e = view.matrixWorld.elements;
    const x = Math.round(e[12] / GRID) * GRID;
    const y = Math.round(e[13] / GRID) * GRID;
    const z = Math.round(e[14] / GRID) * GRID;
    const { origin } = this;
    if (origin.x === x && origin.y === y && origin.z === z) return;
    origin.set(x, y, z);
    for (const member of this.members) member.place = -1;
  }

  /** Casters may come again, to others of a later frame too. */
  private letAllGo(): void {
    for (const { caster } of this.members) {
      caster.merged = null;
      caster.waits = -1;
    }
    for (const caster of this.waiting) caster.waits = -1;
    this.members = [];
    this.waiting.length = 0;
  }

  /** Lets go of all; those that still cast shadows come again. */
  private startAnew(): void {
    this.letAllGo();
    for (const page of this.pages) {
      page.mesh.clear();
      page.objects = 0;
    }
    this.gone = this.triangles = 0;
  }
}

/** A mirrored object's triangles turn the other way. */
function seenSide(side: Side, isMirrored: boolean): Side {
  if (side === DoubleSide || !isMirrored) return side;
  return side === FrontSide ? BackSide : FrontSide;
}
