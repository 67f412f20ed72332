import type { ReactNode } from 'react';
import { type IconName, iconPaths } from '../style/iconPaths';

/** A decorative icon in the text's colour; its meaning must be given as text beside it. */
export function Icon({ name, size = 16 }: { name: IconName; size?: number }): ReactNode {
  return (
    <svg className="icon" viewBox="0 0 16 16" width={size} height={size} aria-hidden="true">
      <path d={iconPaths[name]} />
    </svg>
  );
}
