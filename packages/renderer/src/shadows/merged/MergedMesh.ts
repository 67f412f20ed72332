import {
  BufferAttribute,
  BufferGeometry,
  type Camera,
  DynamicDrawUsage,
  GLBufferAttribute,
  type Material,
  Mesh,
  Sphere,
  type WebGLRenderer,
} from 'three';
import { casterStand } from '../casterStand';
import type { CasterMatrices } from './CasterMatrices';
import type { CasterPlacement } from './CasterPlacement';
import type { TriangleRuns } from './TriangleRuns';

/** Vertices, and indices, of the smallest buffers. */
const SMALLEST = 4096;

/**
 * One mesh that holds the triangles of many: what is added stays where it is put. It draws runs of its indices in one call,
 * by what three has for its own batched meshes.
 */
export class MergedMesh {
  /** What three draws: a mesh that passes for a batched one without textures of its own. */
  readonly mesh: Mesh;
  /** Stands in for it in three's traversal, so that its buffers are sent. */
  readonly stand: Mesh;
  vertices = 0;
  indices = 0;
  /** Own space of their objects, and which object. */
  private corners = new Float32Array(SMALLEST * 4);
  private buffers: ReturnType<CasterPlacement['makeBuffers']>;
  /** Vertices that have been sent, and range of those that are to be placed anew. */
  private sent = 0;
  private firstMoved = Infinity;
  private lastMoved = -1;
  private readonly batch = {
    isBatchedMesh: true,
    _colorsTexture: null,
    _matricesTexture: null,
    _indirectTexture: null,
    _multiDrawStarts: new Int32Array(0),
    _multiDrawCounts: new Int32Array(0),
    _multiDrawCount: 0,
  };

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly placement: CasterPlacement,
    material: Material,
  ) {
    this.buffers = placement.makeBuffers(SMALLEST);
    this.mesh = new Mesh(this.makeGeometry(new Uint32Array(SMALLEST)), material);
    this.mesh.matrixAutoUpdate = this.mesh.matrixWorldAutoUpdate = false;
    Object.assign(this.mesh, this.batch);
    this.stand = casterStand(this.mesh) as Mesh;
  }

  /**
   * Adds triangles.
   * @param positions 3 numbers each
   * @param index of vertices among those
   * @param object number of the object, kept with each vertex
   * @returns the first of their indices
   */
  add(positions: Float32Array, index: Uint32Array, object: number): number {
    const count = positions.length / 3;
    const first = this.indices;
    this.reserve(this.vertices + count, first + index.length);
    const { corners } = this;
    for (let i = 0, at = this.vertices * 4; i < count; i++, at += 4) {
      corners[at] = positions[i * 3];
      corners[at + 1] = positions[i * 3 + 1];
      corners[at + 2] = positions[i * 3 + 2];
      corners[at + 3] = object;
    }
    const own = this.mesh.geometry.index!;
    for (let i = 0; i < index.length; i++) own.array[first + i] = index[i] + this.vertices;
    own.addUpdateRange(first, index.length);
    own.needsUpdate = true;
    this.vertices += count;
    this.indices += index.length;
    return first;
  }

  /** Says that vertices are to be placed anew. */
  move(first: number, count: number): void {
    this.firstMoved = Math.min(this.firstMoved, first);
    this.lastMoved = Math.max(this.lastMoved, first + count);
  }

  /** Places what was moved. Call inside a frame, once the matrices are sent. */
  place(matrices: CasterMatrices): void {
    const { buffers, placement, sent, vertices, firstMoved, lastMoved } = this;
    if (vertices > sent) placement.send(buffers.from, this.corners, sent, vertices - sent);
    this.sent = vertices;
    if (lastMoved > firstMoved) placement.run(buffers.array, buffers.to, matrices, firstMoved, lastMoved - firstMoved);
    this.firstMoved = Infinity;
    this.lastMoved = -1;
  }

  /** Lets go of all triangles; the buffers stay. */
  clear(): void {
    this.vertices = this.indices = this.sent = 0;
    this.firstMoved = Infinity;
    this.lastMoved = -1;
  }

  /** Makes new buffers, since the context has lost those that were. All is to be moved. */
  lose(): void {
    this.remake(this.corners.length / 4, this.mesh.geometry.index!.count);
  }

  /** Says what the next draw draws for a camera. */
  select(runs: TriangleRuns, camera: Camera): void {
    const batch = this.mesh as unknown as MergedMesh['batch'];
    batch._multiDrawStarts = runs.starts;
    batch._multiDrawCounts = runs.counts;
    batch._multiDrawCount = runs.count;
    this.mesh.modelViewMatrix.multiplyMatrices(camera.matrixWorldInverse, this.mesh.matrixWorld);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.letGo();
  }

  private reserve(vertices: number, indices: number): void {
    const mostVertices = this.corners.length / 4;
    const mostIndices = this.mesh.geometry.index!.count;
    if (vertices <= mostVertices && indices <= mostIndices) return;
    this.remake(atLeast(mostVertices, vertices), atLeast(mostIndices, indices));
  }

  private remake(vertices: number, indices: number): void {
    const before = this.mesh.geometry;
    const index = new Uint32Array(indices);
    index.set(before.index!.array);
    if (vertices * 4 > this.corners.length) {
      const corners = new Float32Array(vertices * 4);
      corners.set(this.corners);
      this.corners = corners;
    }
    before.dispose();
    this.letGo();
    this.buffers = this.placement.makeBuffers(vertices);
    this.mesh.geometry = this.makeGeometry(index);
    this.sent = 0;
    this.move(0, this.vertices);
  }

  private letGo(): void {
    const gl = this.webgl.getContext() as WebGL2RenderingContext;
    gl.deleteBuffer(this.buffers.from);
    gl.deleteBuffer(this.buffers.to);
    gl.deleteVertexArray(this.buffers.array);
  }

  private makeGeometry(indices: Uint32Array): BufferGeometry {
    const { FLOAT } = this.webgl.getContext();
    const geometry = new BufferGeometry();
    const count = this.corners.length / 4;
    const position = new GLBufferAttribute(this.buffers.to, FLOAT, 3, 4, count);
    geometry.setAttribute('position', position as unknown as BufferAttribute);
    const index = new BufferAttribute(indices, 1);
    index.usage = DynamicDrawUsage;
    geometry.setIndex(index);
    geometry.boundingSphere = new Sphere(); // three asks for it when it sorts
    return geometry;
  }
}

function atLeast(size: number, wanted: number): number {
  while (size < wanted) size *= 2;
  return size;
}
