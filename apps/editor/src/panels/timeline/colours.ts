/** Colours of the timeline's canvas in the current theme. */
export interface TimelineColours {
  readonly text: string;
  readonly dim: string;
  readonly line: string;
  readonly lineStrong: string;
  readonly panel: string;
  readonly strip: string;
  readonly hover: string;
  readonly accent: string;
  readonly selected: string;
  readonly error: string;
  readonly channels: readonly [string, string, string];
}

const names = ['text', 'dim', 'line', 'line-strong', 'panel', 'strip', 'hover', 'accent', 'selected', 'error'] as const;

/** Reads the theme's colours. @param probe - a hidden element of the panel */
export function readColours(probe: HTMLElement): TimelineColours {
  const colourOf = (name: string): string => {
    probe.style.color = `var(--${name})`;
    return getComputedStyle(probe).color;
  };
  const [text, dim, line, lineStrong, panel, strip, hover, accent, selected, error] = names.map(colourOf);
  const channels = [colourOf('x'), colourOf('y'), colourOf('z')] as const;
  return { text, dim, line, lineStrong, panel, strip, hover, accent, selected, error, channels };
}
