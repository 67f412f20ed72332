import type { FrameRecorder } from '../../viewport/FrameRecorder';

const COLOURS = ['#5f9df5', '#ffa044', '#7cc35a', '#d79be8', '#f0696f', '#4fc4c4', '#e0c34f', '#9aa7ff', '#c98d6b'];

const known = new Map<string, string>();

/** Colour of a pass in the graph, the same until the page is closed. */
export function passColour(name: string): string {
  let colour = known.get(name);
  if (!colour) known.set(name, (colour = COLOURS[known.size % COLOURS.length]));
  return colour;
}

/** Possible ends of the graph's axis (ms). */
const TOPS = [0.5, 1, 2, 4, 8, 16.7, 33.3, 66.7, 133, 267, 533, 1067, 2133, 4267];

/** Draws the stacked times of the passes, the last frame at the right. */
export function drawPassGraph(canvas: HTMLCanvasElement, recorder: FrameRecorder, kind: 'cpu' | 'gpu'): void {
  const context = canvas.getContext('2d')!;
  const ratio = devicePixelRatio;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  const longest = recorder.longest(kind);
  const top = TOPS.find((each) => each >= longest) ?? longest;
  const step = width / recorder.length;
  const { passes } = recorder;
  const style = getComputedStyle(canvas);
  for (let i = 0; i < recorder.length; i++) {
    let base = height;
    for (const times of passes) {
      const time = times[kind][(recorder.frames + i) % recorder.length];
      if (time <= 0) continue;
      const tall = (time / top) * height;
      context.fillStyle = passColour(times.name);
      context.fillRect(i * step, base - tall, Math.max(step - 0.5, 0.5), tall);
      base -= tall;
    }
  }
  context.fillStyle = context.strokeStyle = style.color;
  context.globalAlpha = 0.35;
  context.beginPath();
  context.moveTo(0, height / 2 + 0.5);
  context.lineTo(width, height / 2 + 0.5);
  context.stroke();
  context.globalAlpha = 1;
  context.font = '10px system-ui, sans-serif';
  context.fillText(`${top} ms`, 4, 11);
  context.fillText(`${Number((top / 2).toPrecision(3))}`, 4, height / 2 - 3);
}
