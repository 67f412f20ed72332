import type { BufferGeometry } from 'three';
import { cancellable } from '../base/cancellable';
import { computeCreaseNormals, computeCreaseNormalsInSlices } from '../geometry/computeCreaseNormals';

/** Number of triangle corners above which normals are computed in slices: about 50 ms of work. */
const MANY_CORNERS = 100_000;

interface Computation {
  readonly promise: Promise<BufferGeometry>;
  readonly control: AbortController;
  /** Number of callers that wait for the result; the computation is aborted at 0. */
  waiting: number;
}

/** Rounds a crease angle to 1e-4 rad, so that nearly equal angles share a copy. */
const keyOf = (creaseAngle: number): number => Math.round(creaseAngle * 1e4) / 1e4;

const isLarge = ({ index, attributes }: BufferGeometry): boolean => (index ?? attributes.position).count > MANY_CORNERS;

/** Copies with normals of geometries that have none, one for each crease angle. */
export class MeshNormals {
  private readonly made = new Map<BufferGeometry, Map<number, BufferGeometry>>();
  private readonly computing = new Map<BufferGeometry, Map<number, Computation>>();

  /** Whether `get` can return the mesh with normals without a long computation. */
  isReady(geometry: BufferGeometry, creaseAngle: number): boolean {
    const isThere = geometry.hasAttribute('normal') || this.made.get(geometry)?.has(keyOf(creaseAngle));
    return isThere || !isLarge(geometry);
  }

  /**
   * The geometry itself when it has normals, else its copy with normals, computed now if need be.
   * @param creaseAngle - radians
   */
  get(geometry: BufferGeometry, creaseAngle: number): BufferGeometry {
    if (geometry.hasAttribute('normal')) return geometry;
    const angle = keyOf(creaseAngle);
    return this.made.get(geometry)?.get(angle) ?? this.keep(geometry, angle, computeCreaseNormals(geometry, angle));
  }

  /**
   * Computes normals like `get`, in slices, so that the page stays responsive.
   * @param signal - cancels the wait, and the work when nobody else waits for it
   * @throws the signal's abort reason (as a rejection)
   */
  prepare(geometry: BufferGeometry, creaseAngle: number, signal?: AbortSignal): Promise<BufferGeometry> {
    if (signal?.aborted) return Promise.reject(signal.reason as Error);
    if (this.isReady(geometry, creaseAngle)) return Promise.resolve(this.get(geometry, creaseAngle));
    const computation = this.compute(geometry, keyOf(creaseAngle));
    computation.waiting++;
    signal?.addEventListener('abort', () => --computation.waiting === 0 && computation.control.abort(), { once: true });
    return cancellable(computation.promise, signal, () => {});
  }

  /** Whether no normals are being computed. */
  get isSettled(): boolean {
    return this.computing.size === 0;
  }

  /** Resolves when the normals being computed now are done. */
  async settled(): Promise<void> {
    const all = [...this.computing.values()].flatMap((angles) => [...angles.values()]);
    await Promise.allSettled(all.map(({ promise }) => promise));
  }

  /** Cancels a geometry's computations and drops its copies; present users keep theirs. */
  forget(geometry: BufferGeometry): void {
    for (const { control } of this.computing.get(geometry)?.values() ?? []) control.abort();
    this.made.delete(geometry);
  }

  dispose(): void {
    for (const copies of this.made.values()) for (const copy of copies.values()) copy.dispose();
    for (const geometry of [...this.made.keys(), ...this.computing.keys()]) this.forget(geometry);
  }

  private compute(geometry: BufferGeometry, angle: number): Computation {
    let angles = this.computing.get(geometry);
    if (!angles) this.computing.set(geometry, (angles = new Map()));
    const before = angles.get(angle);
    // a cancelled computation goes on to the end of its slice: it is not used again
    if (before && !before.control.signal.aborted) return before;
    const control = new AbortController();
    const promise = computeCreaseNormalsInSlices(geometry, angle, control.signal).then((copy) =>
      this.keep(geometry, angle, copy),
    );
    const computation = { promise, control, waiting: 0 };
    angles.set(angle, computation);
    const end = (): void => {
      if (angles.get(angle) === computation) angles.delete(angle);
      if (angles.size === 0 && this.computing.get(geometry) === angles) this.computing.delete(geometry);
    };
    promise.then(end, end);
    return computation;
  }

  private keep(geometry: BufferGeometry, angle: number, copy: BufferGeometry): BufferGeometry {
    let copies = this.made.get(geometry);
    if (!copies) this.made.set(geometry, (copies = new Map()));
    copies.set(angle, copy);
    return copy;
  }
}
