/**
 * Makes the sounds that the sample scenes use, in public/sounds/, from seeded noise and resonances: WAV of 16 bits,
 * mono.
 *
 *     node packages/tools/makeSounds.mjs
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/** Random numbers of 0 to 1, the same in each run (mulberry32). */
function randomOf(/** @type {number} */ seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

/**
 * A resonance of two poles: a function from sample to sample.
 * @param {number} frequency - of its peak (Hz)
 * @param {number} width - of the peak (Hz)
 * @param {number} rate - samples a second
 */
function resonance(frequency, width, rate) {
  const radius = Math.exp((-Math.PI * width) / rate);
  const turn = 2 * radius * Math.cos((2 * Math.PI * frequency) / rate);
  let [last, beforeLast] = [0, 0];
  return (/** @type {number} */ input) => {
    const output = input * (1 - radius) + turn * last - radius * radius * beforeLast;
    [last, beforeLast] = [output, last];
    return output;
  };
}

/** A step on stone: the heel, then the ball of the foot, then grit. */
function step(/** @type {number} */ rate) {
  const random = randomOf(11);
  const samples = new Float32Array(Math.round(rate * 0.34));
  const heel = [resonance(95, 60, rate), resonance(410, 260, rate), resonance(1500, 900, rate)];
  for (let i = 0; i < samples.length; i++) {
    const time = i / rate;
    const burst = (/** @type {number} */ from, /** @type {number} */ decay) =>
      time < from ? 0 : Math.min(1, (time - from) / 0.002) * Math.exp(-(time - from) / decay);
    const noise = random() * 2 - 1;
    const push = noise * (burst(0, 0.014) + 0.6 * burst(0.085, 0.02));
    samples[i] = 5 * heel[0](push) + 2.2 * heel[1](push) + 0.9 * heel[2](push);
    samples[i] += noise * 0.035 * burst(0.1, 0.06) * (random() < 0.3 ? 1 : 0.2);
  }
  return samples;
}

/** Crickets at night: sound that rings beyond the end continues at the beginning, for a seamless loop. */
function crickets(/** @type {number} */ rate) {
  const random = randomOf(23);
  const seconds = 1.8;
  const samples = new Float32Array(Math.round(rate * seconds));
  // each: the pitch, chirps in the loop, pulses in a chirp, loudness
  const singers = [
    [4150, 3, 4, 0.5],
    [4420, 2, 5, 0.3],
    [3890, 4, 3, 0.2],
    [4700, 3, 3, 0.1],
  ];
  for (const [pitch, chirps, pulses, loudness] of singers) {
    const first = random() * seconds;
    for (let chirp = 0; chirp < chirps; chirp++) {
      const start = first + ((chirp + random() * 0.12) / chirps) * seconds;
      for (let pulse = 0; pulse < pulses; pulse++) {
        const length = 0.019 * rate;
        const from = Math.round((start + pulse * 0.031) * rate);
        for (let i = 0; i < length; i++) {
          const swell = Math.sin((Math.PI * i) / length) ** 1.5 * (0.6 + (0.4 * pulse) / pulses);
          const phase = (2 * Math.PI * (pitch - (120 * i) / length) * i) / rate;
          samples[(from + i) % samples.length] += loudness * swell * Math.sin(phase);
        }
      }
    }
  }
  // the air of the night: tones that fit into the loop a whole number of times
  for (let tone = 0; tone < 160; tone++) {
    const turns = Math.round((80 + random() ** 2 * 1800) * seconds);
    const phase = random() * 2 * Math.PI;
    const loudness = 0.012 / Math.sqrt(1 + turns / 400);
    for (let i = 0; i < samples.length; i++)
      samples[i] += loudness * Math.sin((2 * Math.PI * turns * i) / samples.length + phase);
  }
  return samples;
}

/** A door on dry hinges: it sticks and slips, faster in the middle of its way, and the wood rings. */
function doorCreak(/** @type {number} */ rate) {
  const random = randomOf(37);
  const samples = new Float32Array(Math.round(rate * 1.3));
  const wood = [
    [310, 70, 1],
    [730, 80, 1.5],
    [1240, 120, 1.3],
    [2380, 200, 0.7],
  ].map(([frequency, width, loudness]) => ({ ring: resonance(frequency, width, rate), loudness }));
  let phase = 0;
  let slipRate = 1;
  for (let i = 0; i < samples.length; i++) {
    const part = i / samples.length;
    const speed = 38 + 150 * Math.sin(Math.PI * part) ** 2 + 34 * Math.sin(part * 19);
    phase += (speed * slipRate) / rate;
    let push = (random() * 2 - 1) * 0.02;
    if (phase >= 1) {
      phase -= 1;
      slipRate = 0.8 + 0.4 * random();
      push += 0.7 + 0.6 * random();
    }
    const swell = Math.min(1, part / 0.08) * Math.min(1, (1 - part) / 0.15) * (0.55 + 0.45 * Math.sin(part * 23) ** 2);
    for (const { ring, loudness } of wood) samples[i] += ring(push * swell) * loudness;
  }
  return samples;
}

/** Something heavy falls on stone. */
function thud(/** @type {number} */ rate) {
  const random = randomOf(53);
  const samples = new Float32Array(Math.round(rate * 0.7));
  const stone = [resonance(240, 160, rate), resonance(900, 700, rate)];
  let phase = 0;
  for (let i = 0; i < samples.length; i++) {
    const time = i / rate;
    phase += (2 * Math.PI * (48 + 75 * Math.exp(-time / 0.05))) / rate;
    const noise = (random() * 2 - 1) * (Math.exp(-time / 0.018) + 0.25 * Math.exp(-time / 0.09));
    samples[i] = 0.9 * Math.sin(phase) * Math.min(1, time / 0.003) * Math.exp(-time / 0.13);
    samples[i] += 2.2 * stone[0](noise) + 1.1 * stone[1](noise);
    const after = time - 0.19;
    if (after > 0) samples[i] += 0.22 * Math.sin(2 * Math.PI * 62 * after) * Math.exp(-after / 0.08);
  }
  return samples;
}

/**
 * A WAV file of 16 bits, mono, its loudest sample at `peak` of 1.
 * @param {Float32Array} samples
 * @param {number} rate
 * @param {number} peak
 */
function wavOf(samples, rate, peak) {
  const loudest = samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
  const file = Buffer.alloc(44 + samples.length * 2);
  file.write('RIFF', 0);
  file.writeUInt32LE(file.length - 8, 4);
  file.write('WAVEfmt ', 8);
  file.writeUInt32LE(16, 16);
  file.writeUInt16LE(1, 20);
  file.writeUInt16LE(1, 22);
  file.writeUInt32LE(rate, 24);
  file.writeUInt32LE(rate * 2, 28);
  file.writeUInt16LE(2, 32);
  file.writeUInt16LE(16, 34);
  file.write('data', 36);
  file.writeUInt32LE(samples.length * 2, 40);
  samples.forEach((sample, i) => file.writeInt16LE(Math.round((sample / loudest) * peak * 32767), 44 + i * 2));
  return file;
}

const folder = join(root, 'public/sounds');
mkdirSync(folder, { recursive: true });
for (const [name, make, rate, peak] of /** @type {const} */ ([
  ['step', step, 22050, 0.8],
  ['crickets', crickets, 16000, 0.6],
  ['doorCreak', doorCreak, 22050, 0.8],
  ['thud', thud, 22050, 0.95],
])) {
  const file = wavOf(make(rate), rate, peak);
  writeFileSync(join(folder, `${name}.wav`), file);
  console.log(`${name}.wav: ${file.length} bytes`);
}
