import type { Page } from '@playwright/test';

/**
 * The controls, of a dialog where one is open, that a press at their middle does not reach, scrolled to first where they are within something that scrolls.
 * Left out are the faces of the view cube, which is turned so that half of them look away, and what is hidden from all
 * but the keyboard of its own control.
 */
export const outOfReach = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const dialog = document.querySelector('.dialog') ?? document;
    const selector = 'button, input, select, textarea, a[href], [role="tab"], [role="treeitem"], [tabindex="0"]';
    const name = (element: Element): string =>
      element.getAttribute('aria-label') ?? element.textContent.trim().slice(0, 40) ?? element.className;
    const faults: string[] = [];
    for (const control of dialog.querySelectorAll<HTMLElement>(selector)) {
      if (!control.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true })) continue;
      if (control.closest('[aria-hidden="true"], [inert], .view-cube')) continue;
      control.scrollIntoView({ block: 'nearest', inline: 'nearest' });
      const { left, top, width, height } = control.getBoundingClientRect();
      // skips hidden inputs that a control which draws itself keeps for forms
      if (width <= 1 || height <= 1) continue;
      // of what is larger than the place it scrolls in, the middle of what is shown counts
      let [west, east, north, south] = [left, left + width, top, top + height];
      for (let place = control.parentElement; place; place = place.parentElement) {
        const { overflowX, overflowY } = getComputedStyle(place);
        const frame = place.getBoundingClientRect();
        if (overflowX !== 'visible' && width > frame.width) {
          [west, east] = [Math.max(west, frame.left), Math.min(east, frame.right)];
        }
        if (overflowY !== 'visible' && height > frame.height) {
          [north, south] = [Math.max(north, frame.top), Math.min(south, frame.bottom)];
        }
      }
      const hit = document.elementFromPoint((west + east) / 2, (north + south) / 2);
      const isReached = hit !== null && (control.contains(hit) || hit.closest('label')?.contains(control) === true);
      if (isReached) continue;
      const where = `${Math.round(left)}, ${Math.round(top)}, ${Math.round(width)} x ${Math.round(height)}`;
      faults.push(`${control.tagName} “${name(control)}” at ${where}: ${hit ? hit.outerHTML.slice(0, 90) : 'outside'}`);
    }
    return faults;
  });
