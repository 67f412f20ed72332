import { DoubleSide } from 'three';
import type { Frame } from '../../frame/Frame';
import type { ForwardTwins } from '../../materials/forwardTwin';
import { setObject } from './objectAttribute';
import type { TwinKind } from '../../materials/TwinKind';
import type { RenderItem } from '../../frame/RenderItem';
import { objectNumber, stippleCorner } from './objectNumbers';

/**
 * Draws a transparent item as one layer, or, as three does with a double-sided one, as two: back faces, then front faces. Each
 * layer has an object number and a corner of the stipple of its own.
 * @param opaque - number of opaque items, which have the first object numbers
 * @param layer - number of layers that the frame has drawn before
 * @returns number of layers drawn with this item's included
 */
export function drawLayers(frame: Frame, item: RenderItem, twins: ForwardTwins, opaque: number, layer: number): number {
  const { material } = item;
  const bothSides = material.side === DoubleSide && !material.forceSinglePass;
  if (!bothSides) {
    drawLayer(frame, item, twins.whole, opaque, layer);
    return layer + 1;
  }
  drawLayer(frame, item, twins.back, opaque, layer);
  drawLayer(frame, item, twins.front, opaque, layer + 1);
  return layer + 2;
}

function drawLayer(frame: Frame, item: RenderItem, twin: TwinKind, opaque: number, layer: number): void {
  setObject(frame.gl, objectNumber(opaque + layer), stippleCorner(layer));
  frame.drawTwin(item, twin);
}
