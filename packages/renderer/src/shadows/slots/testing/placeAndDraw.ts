import type { ShadowSlot } from '../ShadowSlot';

/** Gives a slot a region and draws its map, as the atlas and the frame would. For tests. */
export function placeAndDraw(
  slot: ShadowSlot,
  faceWidth: number,
  faceHeight = faceWidth,
  regionWidth = faceWidth,
): void {
  slot.placement.drop();
  slot.placement.place(
    { x: 0, y: 0, width: regionWidth, height: regionWidth },
    faceWidth,
    faceHeight,
    slot.borderOf(faceWidth),
  );
  slot.map.place();
  slot.placed();
  slot.plan(false);
  slot.map.draw();
}
