import type { RenderItem } from '../../frame/RenderItem';
import type { MaterialOrder as Order, OpaqueItems } from '../../frame/RenderQueue';
import type { DirectDraw } from '../../three/directDraw';

/** Maximum number of materials of an order. */
export const MOST_MATERIALS = 64;

/** Shading wasted by the best order of the materials from one index to another, at index one × MOST_MATERIALS + other. */
const least = new Float64Array(MOST_MATERIALS ** 2);
/** Whether that order ends with the first of these materials; else it ends with the last. */
const endsWithFirst = new Uint8Array(MOST_MATERIALS ** 2);
/** Shading wasted if the material of each index is drawn after those of lower indices, as far as they are visited. */
const afterLower = new Float64Array(MOST_MATERIALS);

/**
 * Order of materials that wastes least shading, of those in which each is next, by id, to all that are drawn before it. Items
 * from the pivot's on are drawn in three's order, those below the pivot in the reverse: each follows either items that three
 * draws before it, or items that three draws after it, and one depth function leaves equal depths to the item that three shows.
 */
export class MaterialOrder implements Order {
  pivot = 0;
  /** Ids of the materials that were known when the order was found, ascending, and the rank of each. */
  private ids: readonly number[] = [];
  private readonly ranks = new Uint8Array(MOST_MATERIALS);
  private readonly items: RenderItem[] = [];

  constructor(readonly draw: DirectDraw) {}

  /**
   * Finds the order, by dynamic programming over intervals of ids.
   * @param ids - ids of one material or more, ascending
   * @param wastes - shading wasted if one material is drawn before another, at index one × MOST_MATERIALS + other; if both are
   *   the same, by its own items from far to near
   * @returns shading that the order saves against three's
   */
  find(ids: readonly number[], wastes: Float64Array): number {
    let high = ids.length - 1;
    afterLower.fill(0);
    for (let first = high; first >= 0; first--) {
      const row = first * MOST_MATERIALS;
      let afterHigher = wastes[row + first];
      for (let last = first + 1; last <= high; last++) {
        afterHigher += wastes[last * MOST_MATERIALS + first];
        afterLower[last] += wastes[row + last];
        const firstAtEnd = least[row + MOST_MATERIALS + last] + afterHigher;
        const lastAtEnd = least[row + last - 1] + afterLower[last];
        endsWithFirst[row + last] = firstAtEnd < lastAtEnd ? 1 : 0;
        least[row + last] = Math.min(firstAtEnd, lastAtEnd);
      }
    }
    let saved = -least[high];
    for (const waste of afterLower) saved += waste;
    let low = 0;
    for (let rank = high; rank >= 0; rank--)
      this.ranks[endsWithFirst[low * MOST_MATERIALS + high] === 1 ? low++ : high--] = rank;
    this.ids = ids;
    this.pivot = ids[low];
    return saved;
  }

  sort(queue: OpaqueItems): readonly RenderItem[] | null {
    const { opaque } = queue;
    const { items, pivot } = this;
    const { length } = opaque;
    if (length === 0 || !isBeside(opaque[0], opaque[length - 1])) return null;
    let next = 0;
    for (let i = 0; i < length; i++) {
      const { material, shading } = opaque[i];
      // three draws node materials all at once, and blended ones need what lies behind them
      if (shading === 'nodes' || material.transparent) return null;
      if (material.id >= pivot) continue;
      if (isFar(queue, opaque[i])) return null;
      next++;
    }
    let before = next - 1;
    let rank = this.rankOf(opaque[next]);
    let rankBefore = this.rankOf(opaque[before]);
    items.length = length;
    for (let i = 0; i < length; i++) {
      const item = (items[i] = opaque[rank <= rankBefore ? next++ : before--]);
      if (opaque[next]?.material !== item.material) rank = this.rankOf(opaque[next]);
      if (opaque[before]?.material !== item.material) rankBefore = this.rankOf(opaque[before]);
    }
    return items;
  }

  /** Rank of an item's material: of a new one, that of the next known one away from the pivot. Infinity for no item. */
  rankOf(item: RenderItem | undefined): number {
    if (item === undefined) return Infinity;
    const { ids, pivot, ranks } = this;
    const { id } = item.material;
    let at = id < pivot ? ids.length - 1 : 0;
    if (id < pivot) while (at >= 0 && ids[at] > id) at--;
    else while (at < ids.length && ids[at] < id) at++;
    return at >= 0 && at < ids.length ? ranks[at] : ids.length;
  }
}

/** Whether an item's depth may equal the cleared depth, so that LessDepth would hide it. */
export function isFar(queue: OpaqueItems, { material, object, geometry }: RenderItem): boolean {
  return material.polygonOffset || queue.reaches(object, geometry, queue.cleared);
}

/** Whether two items may be drawn in either order. */
export function isBeside(a: RenderItem, b: RenderItem): boolean {
  return a.groupOrder === b.groupOrder && a.renderOrder === b.renderOrder;
}
