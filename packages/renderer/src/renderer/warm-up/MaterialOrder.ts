import type { Material } from 'three';
import type { RenderItem } from '../../frame/RenderItem';
import type { MaterialOrder as Order } from '../../frame/RenderQueue';

/** Maximum number of materials of an order. */
export const MOST_MATERIALS = 64;
/** Difference of ranks for a difference of 1 between ids: no id comes near 2^30, and ranks are exact to 2^-46. */
const STEP = 2 ** -31;

/** Shading wasted by the best order of the materials from one index to another, at index one × MOST_MATERIALS + other. */
const least = new Float64Array(MOST_MATERIALS ** 2);
/** Whether that order ends with the first of these materials; else it ends with the last. */
const takesLowest = new Uint8Array(MOST_MATERIALS ** 2);
/** Shading wasted if the material of each index is drawn after those of lower indices, as far as they are visited. */
const afterLower = new Float64Array(MOST_MATERIALS);

/**
 * Order of materials that wastes least shading, of those in which each is next, by id, to all that are drawn before it: they
 * have only higher ids, or only lower ones, so that one depth function leaves equal depths to the highest id, as in three.
 */
export class MaterialOrder implements Order {
  /** Number of materials; 0 where three's order is as good. */
  count = 0;
  pivot = 0;
  private readonly ids = new Float64Array(MOST_MATERIALS);
  private readonly ranks = new Float64Array(MOST_MATERIALS);
  private readonly items: RenderItem[] = [];
  /** Index of each material's first item, and the material's rank, in the order of ranks. */
  private readonly starts = new Float64Array(MOST_MATERIALS);
  private readonly itemRanks = new Float64Array(MOST_MATERIALS);

  /**
   * Finds the order, by dynamic programming over intervals of ids.
   * @param ids - ids of materials, ascending
   * @param wastes - shading wasted if one material is drawn before another, at index one × MOST_MATERIALS + other; if both are
   *   the same, by its own items from far to near
   * @returns shading that the order saves against three's
   */
  find(ids: ArrayLike<number>, count: number, wastes: Float64Array): number {
    afterLower.fill(0);
    for (let low = count - 1; low >= 0; low--) {
      const row = low * MOST_MATERIALS;
      let afterHigher = wastes[row + low];
      least[row + low] = 0;
      for (let high = low + 1; high < count; high++) {
        afterHigher += wastes[high * MOST_MATERIALS + low];
        afterLower[high] += wastes[row + high];
        const lowestLast = least[row + MOST_MATERIALS + high] + afterHigher;
        const highestLast = least[row + high - 1] + afterLower[high];
        takesLowest[row + high] = lowestLast < highestLast ? 1 : 0;
        least[row + high] = Math.min(lowestLast, highestLast);
      }
    }
    let byIds = 0;
    for (let high = 0; high < count; high++) byIds += afterLower[high];
    this.ids.set(ids);
    let low = 0;
    let high = count - 1;
    while (low < high) {
      const rank = high - low;
      if (takesLowest[low * MOST_MATERIALS + high]) this.ranks[low++] = rank;
      else this.ranks[high--] = rank;
    }
    this.ranks[low] = 0;
    this.count = count;
    this.pivot = ids[low];
    return count === 0 ? 0 : byIds - least[count - 1];
  }

  sort(opaque: readonly RenderItem[]): readonly RenderItem[] | null {
    const { starts, itemRanks, items } = this;
    if (this.count === 0 || opaque.length === 0 || !isBeside(opaque[0], opaque[opaque.length - 1])) return null;
    let materials = 0;
    let last: Material | null = null;
    for (let i = 0; i < opaque.length; i++) {
      const { material, shading } = opaque[i];
      if (material === last) continue;
      // three draws node materials all at once, and blended ones need what lies behind them
      if (materials === MOST_MATERIALS || shading === 'nodes' || material.transparent) return null;
      const rank = this.rankOf(material.id);
      let at = materials++;
      for (; at > 0 && itemRanks[at - 1] > rank; at--) {
        itemRanks[at] = itemRanks[at - 1];
        starts[at] = starts[at - 1];
      }
      itemRanks[at] = rank;
      starts[at] = i;
      last = material;
    }
    let drawn = 0;
    for (let at = 0; at < materials; at++) {
      const { material } = opaque[starts[at]];
      const from = drawn;
      for (let i = starts[at]; i < opaque.length && opaque[i].material === material; i++) items[drawn++] = opaque[i];
      if (material.id < this.pivot) reverse(items, from, drawn - 1);
    }
    items.length = drawn;
    return items;
  }

  /** Rank of a material: a new one comes just before the next one on its side of the pivot. */
  rankOf(id: number): number {
    const { ids, count, pivot } = this;
    let at = id < pivot ? count - 1 : 0;
    if (id < pivot) while (at >= 0 && ids[at] > id) at--;
    else while (at < count && ids[at] < id) at++;
    if (at >= 0 && at < count) return this.ranks[at] - Math.abs(ids[at] - id) * STEP;
    return count + Math.abs(id - pivot) * STEP;
  }
}

function reverse(items: RenderItem[], from: number, to: number): void {
  for (; from < to; from++, to--) {
    const item = items[from];
    items[from] = items[to];
    items[to] = item;
  }
}

/** Whether two items may be drawn in either order. */
export function isBeside(a: RenderItem, b: RenderItem): boolean {
  return a.groupOrder === b.groupOrder && a.renderOrder === b.renderOrder;
}
