import type { Rectangle } from './placeLayout';

/** Height of the tabs at the bottom of a small window (CSS pixels). */
export const SHEET_TABS = 46;

/** Width or height of the divider between viewport and panel (CSS pixels). */
export const SHEET_EDGE = 12;

/** Whether a window (CSS pixels) has space for only one panel beside the viewport, as on a phone or at high zoom. */
export const isSmallWindow = (width: number, height: number): boolean =>
  width < 700 || height < 400 || (width < 840 && height < 700);

export interface PlacedSheet {
  readonly main: Rectangle;
  /** Rectangle of the panel, and of the divider; null when there is no panel. */
  readonly sheet: Rectangle | null;
  readonly edge: Rectangle | null;
  readonly tabs: Rectangle;
  /** Whether the panel is below the viewport, or else at its right. */
  readonly isBelow: boolean;
}

/**
 * Places viewport, one panel and the tabs in a small window: the panel is below in an upright window, else at the
 * right.
 * @param width - width of the dock (CSS pixels) @param height - its height (CSS pixels)
 * @param share - share that the panel takes, 0 to 1; null for no panel
 */
export function placeSheet(width: number, height: number, share: number | null): PlacedSheet {
  const rest = Math.max(0, height - SHEET_TABS);
  const tabs = { x: 0, y: rest, width, height: SHEET_TABS };
  const isBelow = rest > width;
  const whole = { x: 0, y: 0, width, height: rest };
  if (share === null) return { main: whole, sheet: null, edge: null, tabs, isBelow };
  const extent = isBelow ? rest : width;
  const size = Math.round(extent * share);
  const at = extent - size - SHEET_EDGE;
  if (isBelow) {
    return {
      main: { ...whole, height: at },
      edge: { ...whole, y: at, height: SHEET_EDGE },
      sheet: { ...whole, y: at + SHEET_EDGE, height: size },
      tabs,
      isBelow,
    };
  }
  return {
    main: { ...whole, width: at },
    edge: { ...whole, x: at, width: SHEET_EDGE },
    sheet: { ...whole, x: at + SHEET_EDGE, width: size },
    tabs,
    isBelow,
  };
}
