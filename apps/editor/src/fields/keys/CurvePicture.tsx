import type { Curve } from '@farol/engine/fields';
import type { ReactNode } from 'react';
import { curvePoints, type ValueRange } from './valueRange';

/** A curve as a line with a tinted area below, filling its container. */
export function CurvePicture({ curve, range }: { curve: Curve; range: ValueRange }): ReactNode {
  const points = curvePoints(curve, range);
  return (
    <svg className="curve-picture" viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
      <polygon points={`0,1 ${points} 1,1`} />
      <polyline points={points} />
    </svg>
  );
}
