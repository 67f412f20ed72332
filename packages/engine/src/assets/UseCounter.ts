/** Resource of three's whose GPU memory `dispose` frees; drawing again uploads again. */
interface Disposable {
  dispose(): void;
}

/** Counts the users of shared geometries and textures, and frees their GPU memory when there are no more. */
export class UseCounter {
  private readonly counts = new Map<Disposable, number>();

  acquire(resource: Disposable): void {
    this.counts.set(resource, this.uses(resource) + 1);
  }

  release(resource: Disposable): void {
    const left = this.uses(resource) - 1;
    if (left > 0) this.counts.set(resource, left);
    else if (this.counts.delete(resource)) resource.dispose();
  }

  uses(resource: Disposable): number {
    return this.counts.get(resource) ?? 0;
  }

  /** Number of resources that have users. */
  get size(): number {
    return this.counts.size;
  }
}
