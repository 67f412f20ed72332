import type { Rectangle } from './placeLayout';

/** Height of the tabs at the bottom of a small window (CSS pixels). */
export const SHEET_TABS = 46;

/** Width or height of the line between the picture and a sheet (CSS pixels). */
export const SHEET_EDGE = 12;

/** Whether a window (CSS pixels) has room for one panel at a time beside the picture, as of a telephone or enlarged twice. */
export const isSmallWindow = (width: number, height: number): boolean =>
  width < 700 || height < 400 || (width < 840 && height < 700);

export interface PlacedSheet {
  /** Of the picture. */
  readonly main: Rectangle;
  /** Of the panel beside or below it, and of the line between; null when there is none. */
  readonly sheet: Rectangle | null;
  readonly edge: Rectangle | null;
  readonly tabs: Rectangle;
  /** Whether the sheet is below the picture, else at its right. */
  readonly isBelow: boolean;
}

/**
 * Where the picture, one panel and the tabs are in a small window: below the picture in an upright one, else at its right.
 * @param width - of the dock (CSS pixels), as is `height`
 * @param share - part that the panel takes, from 0 to 1; null for no panel
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
