import { type ComponentType, lazy, type ReactNode } from 'react';
import type { Tool } from '../../../model/Tools';
import './tools.css';

/** Settings box of each tool, by its id. A new tool takes a line here. */
const boxes: Readonly<Record<string, ComponentType<{ tool: never }>>> = {
  duplicate: lazy(async () => ({ default: (await import('./DuplicateBox')).DuplicateBox })),
  'light-meter': lazy(async () => ({ default: (await import('./MeterBox')).MeterBox })),
  measure: lazy(async () => ({ default: (await import('./MeasureBox')).MeasureBox })),
  'pixel-lighting': lazy(async () => ({ default: (await import('./PixelBox')).PixelBox })),
};

export function ToolBox({ tool }: { readonly tool: Tool }): ReactNode {
  const Box = boxes[tool.id] as ComponentType<{ tool: Tool }> | undefined;
  return Box && <Box tool={tool} />;
}
