/** A line of the readout: the amount of a drag along an axis. */
export interface ReadoutLine {
  /** 'x', 'y' or 'z', shown in the axis's colour; '' for none. */
  readonly axis: string;
  readonly text: string;
  /** Whether the number is being typed, and whether the typed text is not a number. */
  readonly isTyped?: boolean;
  readonly isWrong?: boolean;
}

/** Shows the amount of a drag beside the pointer, and marks the vertex that it snaps to. */
export class DragReadout {
  private readonly box = document.createElement('div');
  private readonly mark = document.createElement('div');
  private shown = '';

  /** @param canvas - canvas of the viewport; the readout becomes its sibling */
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.box.className = 'drag-readout';
    this.mark.className = 'vertex-mark';
    this.box.setAttribute('aria-hidden', 'true');
    this.mark.setAttribute('aria-hidden', 'true');
  }

  /** @param x - pointer position from the canvas's left edge (CSS pixels) @param y - from its top edge */
  show(lines: readonly ReadoutLine[], x: number, y: number): void {
    const { box, canvas } = this;
    const key = JSON.stringify(lines);
    if (key !== this.shown) {
      this.shown = key;
      box.replaceChildren(
        ...lines.map(({ axis, text, isTyped, isWrong }) => {
          const line = document.createElement('div');
          if (isTyped) line.classList.add('typed');
          if (isWrong) line.classList.add('wrong');
          if (axis) {
            const name = document.createElement('b');
            name.className = `axis-${axis}`;
            name.textContent = axis.toUpperCase();
            line.append(name, ' ');
          }
          line.append(text);
          return line;
        }),
      );
    }
    if (!box.isConnected) canvas.parentElement?.append(box);
    const { clientWidth, clientHeight } = canvas;
    const left = x + 18 + box.offsetWidth > clientWidth ? x - 18 - box.offsetWidth : x + 18;
    const top = Math.min(y + 14, clientHeight - box.offsetHeight - 4);
    box.style.transform = `translate(${Math.max(4, left)}px, ${Math.max(4, top)}px)`;
  }

  /** Shows a mark at a point of the viewport (CSS pixels from the upper left corner); null hides it. */
  markAt(point: { readonly x: number; readonly y: number } | null): void {
    const { mark, canvas } = this;
    if (!point) return mark.remove();
    if (!mark.isConnected) canvas.parentElement?.append(mark);
    mark.style.transform = `translate(${point.x}px, ${point.y}px)`;
  }

  hide(): void {
    this.box.remove();
    this.mark.remove();
    this.shown = '';
  }
}
