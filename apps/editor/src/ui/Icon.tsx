import type { ReactNode } from 'react';
import { type IconName, iconPaths } from '../style/iconPaths';

/** An icon of 16 by 16 in the colour of the text; what it stands for must be said beside it. */
export function Icon({ name, size = 16 }: { name: IconName; size?: number }): ReactNode {
  return (
    <svg className="icon" viewBox="0 0 16 16" width={size} height={size} aria-hidden="true">
      <path d={iconPaths[name]} />
    </svg>
  );
}
