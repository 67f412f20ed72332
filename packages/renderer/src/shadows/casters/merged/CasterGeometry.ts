import type { BufferAttribute, BufferGeometry } from 'three';
import { attributeState, hasReadableVertices } from '../../../three/vertexData';
import { CLUSTER_TRIANGLES, ClusterOrder } from './ClusterOrder';

/**
 * The triangles of a geometry as shadow maps draw them: only positions, in clusters that lie close together, see `ClusterOrder`.
 * `step` computes a part at a time.
 */
export class CasterGeometry {
  /** Positions (own space, m), 3 numbers each, of the vertices that triangles use. */
  positions = new Float32Array(0);
  /** Vertex indices, three a triangle, cluster after cluster. */
  index = new Uint32Array(0);
  /** Box of each cluster: centre and half sizes (m), 6 numbers. */
  boxes = new Float32Array(0);
  isDone = false;
  /** False if a position is not a finite number: triangles at such positions cannot be sorted into clusters. */
  isSound = true;
  private readonly position: BufferAttribute;
  private readonly source: BufferAttribute | null;
  private readonly positionState: number;
  private readonly indexState: number;
  private clusters: ClusterOrder | null = null;

  constructor(private readonly geometry: BufferGeometry) {
    this.position = geometry.attributes.position as BufferAttribute;
    this.source = geometry.index;
    this.positionState = attributeState(this.position);
    this.indexState = this.source === null ? 0 : attributeState(this.source);
  }

  get triangles(): number {
    return Math.floor((this.source ?? this.position).count / 3);
  }

  isOf(geometry: BufferGeometry): boolean {
    return geometry === this.geometry;
  }

  /** False once the geometry's positions or index have changed. */
  get isCurrent(): boolean {
    const { attributes, index } = this.geometry;
    if (attributes.position !== this.position || index !== this.source) return false;
    if (attributeState(attributes.position) !== this.positionState) return false;
    return index === null || attributeState(index) === this.indexState;
  }

  /** Whether the CPU can still read the vertices: a page may free them once three has uploaded them. */
  get isReadable(): boolean {
    return this.isDone || hasReadableVertices(this.geometry);
  }

  /**
   * Does a part of the work: merges vertices, then sorts triangles into clusters.
   * @param budget - triangles to visit, roughly
   * @returns triangles visited
   */
  step(budget: number): number {
    if (this.clusters === null) {
      this.clusters = new ClusterOrder(this.centres());
      return this.triangles;
    }
    const visited = this.clusters.step(budget);
    if (!this.clusters.isDone) return visited;
    this.finish(this.clusters.order);
    return visited + this.triangles;
  }

  private vertexOf(corner: number): number {
    return this.source === null ? corner : this.source.getX(corner);
  }

  private centres(): Float32Array {
    const { position } = this;
    const centres = new Float32Array(this.triangles * 3);
    for (let corner = 0; corner < this.triangles * 3; corner++) {
      const vertex = this.vertexOf(corner);
      const at = Math.floor(corner / 3) * 3;
      for (let axis = 0; axis < 3; axis++) centres[at + axis] += position.getComponent(vertex, axis) / 3;
    }
    this.isSound = centres.every(Number.isFinite);
    if (!this.isSound) centres.fill(0);
    return centres;
  }

  private finish(order: Uint32Array): void {
    const { position } = this;
    const known = new Int32Array(position.count).fill(-1);
    this.index = new Uint32Array(order.length * 3);
    // within a cluster, triangles keep the source's order, so that neighbours share vertices in the cache
    for (let i = 0; i < order.length; i += CLUSTER_TRIANGLES) order.subarray(i, i + CLUSTER_TRIANGLES).sort();
    let vertices = 0;
    for (let i = 0; i < this.index.length; i++) {
      const vertex = this.vertexOf(order[Math.floor(i / 3)] * 3 + (i % 3));
      if (known[vertex] < 0) known[vertex] = vertices++;
      this.index[i] = known[vertex];
    }
    this.positions = new Float32Array(vertices * 3);
    for (let vertex = 0; vertex < position.count; vertex++) {
      const at = known[vertex] * 3;
      if (at < 0) continue;
      for (let axis = 0; axis < 3; axis++) this.positions[at + axis] = position.getComponent(vertex, axis);
    }
    this.findBoxes();
    this.clusters = null;
    this.isDone = true;
  }

  private findBoxes(): void {
    const { index, positions } = this;
    const perCluster = CLUSTER_TRIANGLES * 3;
    this.boxes = new Float32Array(Math.ceil(index.length / perCluster) * 6);
    for (let first = 0, at = 0; first < index.length; first += perCluster, at += 6) {
      const end = Math.min(index.length, first + perCluster);
      for (let axis = 0; axis < 3; axis++) {
        let low = Infinity;
        let high = -Infinity;
        for (let i = first; i < end; i++) {
          const value = positions[index[i] * 3 + axis];
          if (value < low) low = value;
          if (value > high) high = value;
        }
        this.boxes[at + axis] = 0.5 * (low + high);
        this.boxes[at + 3 + axis] = 0.5 * (high - low);
      }
    }
  }
}
