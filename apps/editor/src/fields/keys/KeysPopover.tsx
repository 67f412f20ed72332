import { Popover } from '@base-ui/react/popover';
import { type ReactNode, Suspense } from 'react';
import './keys.css';

interface KeysPopoverProps {
  readonly label: string;
  readonly description: string;
  readonly disabled: boolean;
  /** Thumbnail in the button that opens the popover. */
  readonly picture: ReactNode;
  /** Content of the popover; its code may be fetched when it is first opened. */
  readonly children: ReactNode;
}

/** A button that shows a curve or a gradient and opens its editor. */
export function KeysPopover({ label, description, disabled, picture, children }: KeysPopoverProps): ReactNode {
  return (
    <Popover.Root>
      <Popover.Trigger
        className="colour keys-button"
        aria-label={label}
        aria-description={description}
        disabled={disabled}
      >
        {picture}
      </Popover.Trigger>
      <Popover.Portal>
        <Popover.Positioner className="positioner" sideOffset={4} align="end" collisionPadding={6}>
          <Popover.Popup className="popup keys-popup" aria-label={label}>
            <Suspense fallback={<div className="keys-waiting" />}>{children}</Suspense>
          </Popover.Popup>
        </Popover.Positioner>
      </Popover.Portal>
    </Popover.Root>
  );
}
