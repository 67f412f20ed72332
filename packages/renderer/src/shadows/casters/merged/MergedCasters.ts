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
import type { GeometryGroup } from '../../../three/RenderListItem';
import type { MicroShaderRegistry } from '../../../microshaders';
import { PassMaterial } from '../../../gpu/PassMaterial';
import { shadowSideOf } from '../CasterMaterials';
import { cubeFacesOf } from '../../slots/cubeFacesOf';
import { moveBox } from '../moveBox';
import { isBeyond } from '../../slots/reach';
import { isBelow } from '../../isBelow';
import type { Caster, MergedCaster } from '../Caster';
import type { ShadowCasters } from '../ShadowCasters';
import type { ShadowFace } from '../../slots/ShadowFace';
import type { ShadowSlot } from '../../slots/ShadowSlot';
import { CasterGeometry } from './CasterGeometry';
import { CasterMatrices } from './CasterMatrices';
import { addCubeRuns, addMapRuns } from './clusterRuns';
import { CLUSTERS_PER_GROUP } from './ClusterOrder';
import { uniteBoxes } from '../uniteBoxes';
import { isMergeable } from './isMergeable';
import { MergedMesh } from './MergedMesh';
import { directDraw, type DirectDraw } from '../../../three/directDraw';
import { isCompiled, programHandle } from '../../../three/handles';

/** Number of scene traversals in which a caster must be unchanged before it is merged. */
const SETTLED = 30;
/** Maximum number of merged triangles: each takes about 22 bytes on the GPU, and as many in the CPU's memory. */
const MOST_TRIANGLES = 2_000_000;
/** Maximum number of triangles sorted in a frame while casters wait to be merged, so that no frame is late. */
const BUDGET = 150_000;
/** Number of triangles, or casters, removed from the scene before their room in the buffers is reclaimed. */
const FEW_GONE = 65_536;
const FEW_LOST = 256;
/** Number of traversals between sweeps; a caster absent for more is dropped. Frames that draw no maps do not sweep. */
const SWEEP = 256;
/** Number of merged casters missing in a frame above which a sweep looks for those removed from the scene. */
const FEW_ABSENT = 64;
/** Grid (m) to which the origin of caster matrices is snapped: positions near the origin keep more digits. */
const GRID = 128;

const clipFromWorld = new Matrix4();
const anyCamera = new PerspectiveCamera(); // argument of three's draw; has no effect on where casters are drawn
/** Group without triangles: three binds program and buffers, and draws nothing. */
const NO_TRIANGLES: GeometryGroup = { start: 0, count: 0 };
/** Group with which three compiles the program, and makes no draw call. */
const NO_DRAW: GeometryGroup = { start: 1, count: -1 };

/** Merged casters drawn as one mesh, up to the number of matrices in one uniform block. */
interface Page {
  readonly mesh: MergedMesh;
  readonly matrices: CasterMatrices;
  objects: number;
}

/**
 * Casters of a scene whose triangles lie in one buffer, in small clusters, so that one call draws all clusters that a face of a
 * shadow map shows. A budget of casters is merged each frame; those not merged yet are drawn one by one.
 */
export class MergedCasters {
  private readonly pages: Page[] = [];
  private readonly capacity: number;
  private readonly material: PassMaterial;
  private readonly geometries = new WeakMap<BufferGeometry, CasterGeometry>();
  private members: MergedCaster[] = [];
  /** Merged casters that cast shadows in this frame. */
  private readonly present: MergedCaster[] = [];
  /** World-space boxes of `present`, 6 numbers each, side by side for the cache's sake. */
  private presentBoxes = new Float64Array(6 * 64);
  private readonly queue: Caster[] = [];
  private readonly origin = new Vector3();
  private readonly gl: WebGL2RenderingContext;
  private readonly drawDirect: DirectDraw;
  private multiDraw: WEBGL_multi_draw | null = null;
  private readonly matrixFloats = new Float32Array(16);
  private matrixLocation: WebGLUniformLocation | null = null;
  /** Page × 3 + side that three has bound for draws; -1 for none. */
  private bound = -1;
  /** Number of triangles in the buffers whose casters have been removed from the scene. */
  private removedTriangles = 0;
  private triangles = 0;
  /** Number of casters removed from the scene that still take up a matrix; `startAnew` frees these. */
  private lost = 0;
  private swept = 0;
  private hidden = 0;

  constructor(
    private readonly webgl: WebGLRenderer,
    registry: MicroShaderRegistry,
  ) {
    this.gl = webgl.getContext() as WebGL2RenderingContext;
    this.drawDirect = directDraw(webgl);
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

  /** Adds the proxies by which three's traversal uploads the merged triangles. */
  addProxies(proxies: Object3D[]): void {
    for (const { mesh } of this.pages) proxies.push(mesh.proxy);
  }

  /**
   * Begins a frame in which maps may be drawn: merges some of the waiting casters.
   * @param camera - camera near which the matrices' origin lies
   * @param casters - casters of the scene
   * @param loose - receives the casters that are not merged
   */
  begin(camera: Camera, { list, count, walks, walked }: ShadowCasters, loose: Caster[]): void {
    this.moveOrigin(camera);
    if (walks - this.swept >= SWEEP) this.sweep(walks, walked);
    const manyGone = this.removedTriangles > FEW_GONE && this.removedTriangles * 2 > this.triangles;
    if (manyGone || (this.lost > FEW_LOST && this.lost > this.members.length)) this.startAnew();
    for (let i = 0; i < count; i++) this.find(list[i]);
    for (let left = BUDGET; left > 0 && this.queue.length > 0;) {
      const caster = this.queue[this.queue.length - 1];
      left -= this.mergeNext(caster, walks);
    }
    this.present.length = 0;
    for (let i = 0; i < count; i++) {
      const merged = this.find(list[i]);
      if (merged !== null) this.present.push(merged);
      else loose.push(list[i]);
    }
    const { present } = this;
    const absent = this.members.length - present.length;
    if (absent < this.hidden) this.hidden = absent;
    if (absent > this.hidden + FEW_ABSENT) this.sweep(walks, walked);
    if (present.length * 6 > this.presentBoxes.length) this.presentBoxes = new Float64Array(present.length * 12);
    for (let i = 0; i < present.length; i++) this.presentBoxes.set(present[i].caster.box, i * 6);
  }

  /** Entry of a caster among the merged ones; null if it is not merged, in which case it may be queued. */
  find(caster: Caster): MergedCaster | null {
    const { merged } = caster;
    if (merged !== null && this.isSame(merged)) return merged;
    if (merged !== null) this.letGo(caster);
    if (caster.queuedVersion === caster.signatureVersion) return null;
    // a caster that changes frame after frame is drawn by itself
    if (caster.signatureVersion > 1 && caster.lastWalk - caster.signatureWalk < SETTLED) return null;
    caster.queuedVersion = caster.signatureVersion;
    if (caster.hasBox && isMergeable(caster.object)) this.queue.push(caster);
    return null;
  }

  /** Whether a caster's triangles are still those merged: its signature may have changed by its material alone. */
  private isSame(merged: MergedCaster): boolean {
    const { caster, geometry } = merged;
    const { object, hasBox, signatureVersion } = caster;
    if (!hasBox || !geometry.isCurrent || object.onAfterShadow !== Object3D.prototype.onAfterShadow) return false;
    if (merged.signatureVersion === signatureVersion) return true;
    if (!geometry.isOf((object as Mesh).geometry) || !isMergeable(object)) return false;
    merged.signatureVersion = signatureVersion;
    return true;
  }

  /** Drops absent casters: those removed from the scene, and those hidden for long. */
  private sweep(walks: number, root: Object3D | null): void {
    this.swept = walks;
    const { length } = this.members;
    for (const { caster } of this.members)
      if (walks - caster.lastWalk > SWEEP || (caster.lastWalk !== walks && !isBelow(caster.object, root)))
        this.letGo(caster);
    this.members = this.members.filter((member) => member.caster.merged === member);
    this.lost += length - this.members.length;
    this.hidden = this.members.length - this.present.length;
  }

  private letGo(caster: Caster): void {
    if (caster.merged === null) return;
    this.removedTriangles += caster.merged.geometry.triangles;
    caster.merged = null;
    caster.queuedVersion = -1;
  }

  /** Adds to the runs of each face of a light's map the clusters that the drawn part of the face may show. */
  addTo(slot: ShadowSlot, bothSides: boolean): void {
    const { isCube, reach, layers, drawnFaces } = slot;
    const { present, presentBoxes: boxes } = this;
    for (let i = 0; i < present.length; i++) {
      if (isCube ? (cubeFacesOf(boxes, i * 6, reach) & drawnFaces) === 0 : isBeyond(reach, boxes, i * 6)) continue;
      const merged = present[i];
      const { object } = merged.caster;
      if ((object.layers.mask & layers) === 0) continue;
      this.follow(merged);
      const side = drawnSide(shadowSideOf((object as Mesh).material as Material, bothSides), merged.isMirrored);
      if (isCube) addCubeRuns(slot, merged, side);
      else addMapRuns(slot, merged, side);
    }
  }

  /** Uploads the casters' matrices, and compiles the program of merged casters if needed. */
  prepare(): void {
    const { gl, pages, material, webgl } = this;
    if (!isCompiled(webgl, material)) {
      // the program is new, was edited, or was lost with the GL context
      for (const { matrices } of pages) matrices.lose();
      this.show(pages[0].mesh, NO_DRAW);
      const { extensions } = webgl;
      const name = 'WEBGL_multi_draw';
      this.multiDraw = extensions.has(name) ? (extensions.get(name) as unknown as WEBGL_multi_draw) : null;
      const program = programHandle(webgl, material);
      pages[0].matrices.attach(program);
      this.matrixLocation = gl.getUniformLocation(program, 'farol_clipFromOrigin');
    }
    for (const { matrices } of pages) matrices.send();
    this.interrupt();
  }

  /** Notes that three may have bound other buffers. Call after any other draw. */
  interrupt(): void {
    this.bound = -1;
  }

  /** Draws the merged triangles that a shadow face needs into the viewport. */
  draw(face: ShadowFace): void {
    const { gl, webgl, matrixFloats } = this;
    const { x, y, z } = this.origin;
    let hasMatrix = false;
    for (let page = 0; page < this.pages.length; page++) {
      for (let side = 0; side < 3; side++) {
        const { count, starts, counts } = face.runs(page, side);
        if (count === 0) continue;
        if (this.bound !== page * 3 + side) this.bind(page, side as Side);
        if (!hasMatrix) {
          const { projectionMatrix, matrixWorldInverse } = face.camera;
          const e = clipFromWorld.multiplyMatrices(projectionMatrix, matrixWorldInverse).elements;
          for (let i = 0; i < 12; i++) matrixFloats[i] = e[i];
          for (let i = 0; i < 4; i++) matrixFloats[12 + i] = e[i] * x + e[4 + i] * y + e[8 + i] * z + e[12 + i];
          gl.uniformMatrix4fv(this.matrixLocation, false, matrixFloats);
          hasMatrix = true;
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

  /** Binds the program and buffers of a page by three; later draws only pass their triangles. */
  private bind(page: number, side: Side): void {
    const { mesh, matrices } = this.pages[page];
    matrices.bind();
    this.material.side = side;
    this.show(mesh, NO_TRIANGLES);
    this.bound = page * 3 + side;
  }

  private show({ mesh }: MergedMesh, part: GeometryGroup): void {
    this.drawDirect(anyCamera, null, mesh.geometry, this.material, mesh, part);
  }

  private addPage(): Page {
    const page = { mesh: new MergedMesh(this.material), matrices: new CasterMatrices(this.webgl), objects: 0 };
    this.pages.push(page);
    return page;
  }

  /** Merges the triangles of the last waiting caster, a part at a time. */
  private mergeNext(caster: Caster, walks: number): number {
    if (caster.queuedVersion !== caster.signatureVersion || caster.merged !== null || caster.lastWalk !== walks) {
      if (caster.merged === null) caster.queuedVersion = -1;
      this.queue.pop();
      return 1;
    }
    const { geometry: source } = caster.object as Mesh;
    let geometry = this.geometries.get(source);
    if (geometry === undefined) this.geometries.set(source, (geometry = new CasterGeometry(source)));
    const room = MOST_TRIANGLES - this.triangles;
    if (!geometry.isCurrent || !geometry.isSound || !geometry.isReadable || geometry.triangles > room) {
      this.queue.pop(); // a geometry that changes, or that the CPU cannot read, is drawn by itself
      return 1;
    }
    if (!geometry.isDone) return geometry.step(BUDGET);
    this.queue.pop();
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
      signatureVersion: caster.signatureVersion,
      boxes: new Float64Array(geometry.boxes.length),
      groups: new Float64Array(Math.ceil(geometry.boxes.length / 6 / CLUSTERS_PER_GROUP) * 6),
      matrixVersion: -1,
      isMirrored: false,
    };
    caster.merged = merged;
    this.members.push(merged);
  }

  /** Updates a caster's boxes and its matrix in the block from its world matrix. */
  follow(merged: MergedCaster): void {
    const { caster, boxes, geometry, page, object } = merged;
    if (merged.matrixVersion === caster.matrixVersion) return;
    merged.matrixVersion = caster.matrixVersion;
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

  /** Moves the origin of the matrices near the camera: far from the origin they would lose precision. */
  private moveOrigin(camera: Camera): void {
    const e = camera.matrixWorld.elements;
    const x = Math.round(e[12] / GRID) * GRID;
    const y = Math.round(e[13] / GRID) * GRID;
    const z = Math.round(e[14] / GRID) * GRID;
    const { origin } = this;
    if (origin.x === x && origin.y === y && origin.z === z) return;
    origin.set(x, y, z);
    for (const member of this.members) member.matrixVersion = -1;
  }

  /** Forgets all casters, so that this or another MergedCasters can merge them again. */
  private letAllGo(): void {
    for (const { caster } of this.members) {
      caster.merged = null;
      caster.queuedVersion = -1;
    }
    for (const caster of this.queue) caster.queuedVersion = -1;
    this.members = [];
    this.queue.length = 0;
  }

  /** Empties the pages; casters that still cast shadows are merged again. */
  private startAnew(): void {
    this.letAllGo();
    for (const page of this.pages) {
      page.mesh.clear();
      page.objects = 0;
    }
    this.removedTriangles = this.triangles = this.lost = 0;
  }
}

/** Side of stored triangles that is drawn: the other one for a mirrored object. */
function drawnSide(side: Side, isMirrored: boolean): Side {
  if (side === DoubleSide || !isMirrored) return side;
  return side === FrontSide ? BackSide : FrontSide;
}
