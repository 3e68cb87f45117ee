import type { Fault } from "../engine/engine";
import type { Size } from "../view/size";
import { words } from "./words";

/** Formats of a film: WebM, which every encoder of a browser gives, and MP4, which phones and slides take. */
export const FORMATS = ["webm", "mp4"] as const;
export type Format = (typeof FORMATS)[number];

/** Choices of a picture: its size, and the parts beside the ship. */
export interface PictureChoice {
  size: Size;
  hasPlots: boolean;
  /** Text of the user in the caption; the caption always has the title and the time. */
  caption: string;
}

/** Choices of a film. */
export interface FilmChoice extends PictureChoice {
  format: Format;
  /** First and last time, s of the run. */
  from_s: number;
  to_s: number;
  frames_per_s: number;
  /** Simulated time over the time of the film. */
  speed: number;
}

/** Sizes that are offered; any other one can be written. */
export const SIZES = ["1280x720", "1920x1080", "1080x1350", "1080x1920", "640x360"];
/** Allowed values. An encoder also has a largest size, which it is asked for. */
export const ALLOWED = { edge: [64, 8192], frames_per_s: [1, 120], speed: [0.01, 1000], caption: 300 } as const;
/** Largest file, bytes: it is held in memory until it is whole. */
export const LARGEST_BYTES = 500e6;
/** Bits per second of 1280x720 at 30 frames per second, and the exponent for other numbers of pixels per second. */
const RATE = { bits_per_s: 8e6, pixels_per_s: 1280 * 720 * 30, exponent: 0.75 };
/** Share of a frame by which a time may be late and still be the last one. */
const SLACK = 1e-6;

/** Reads a size such as `1280x720`; null if the text is not a size. */
export function sizeOf(text: string): Size | null {
  const found = /^\s*(\d{1,5})\s*[x×]\s*(\d{1,5})\s*$/i.exec(text);
  return found && { width: Number(found[1]), height: Number(found[2]) };
}

export const textOfSize = ({ width, height }: Size) => `${width}x${height}`;

/** Returns why a size is not one of a picture; null if it is. */
export function faultOfPicture({ width, height }: Size): Fault | null {
  const [least, most] = ALLOWED.edge;
  const isInside = (edge: number) => Number.isInteger(edge) && edge >= least && edge <= most;
  return isInside(width) && isInside(height) ? null : faultOf(words.wrong_size(`${width}x${height}`, least, most));
}

/** Returns why a film cannot be made of a recording that ends at `end_s`; null if it can. */
export function faultOfFilm(choice: FilmChoice, end_s: number): Fault | null {
  const { size, from_s, to_s, frames_per_s, speed } = choice;
  const isOdd = size.width % 2 !== 0 || size.height % 2 !== 0;
  const longest_s = longestOf(size, frames_per_s);
  const wrong =
    between(words.frames_per_s, frames_per_s, ALLOWED.frames_per_s) ??
    between(words.speed, speed, ALLOWED.speed) ??
    (from_s >= 0 && to_s > from_s && to_s <= end_s + 1e-9 ? null : words.wrong_times(from_s, to_s, Number(end_s.toFixed(3)))) ??
    (isOdd ? words.odd_size(textOfSize(size)) : null) ??
    (countOf(choice) / frames_per_s > longest_s ? words.too_long(countOf(choice) / frames_per_s, longest_s, LARGEST_BYTES / 1e6) : null);
  return faultOfPicture(size) ?? (wrong === null ? null : faultOf(wrong));
}

function between(name: string, value: number, [least, most]: readonly [number, number]): string | null {
  return value >= least && value <= most ? null : words.wrong_number(name, value, least, most);
}

function faultOf(message: string): Fault {
  return { kind: "setting", message };
}

/** Returns the number of frames: the first at `from_s`, the last at or before `to_s`. */
export function countOf({ from_s, to_s, frames_per_s, speed }: FilmChoice): number {
  return Math.floor(((to_s - from_s) * frames_per_s) / speed + SLACK) + 1;
}

/** Returns the time of the run that a frame shows, s. */
export function timeOf({ from_s, to_s, frames_per_s, speed }: FilmChoice, frame: number): number {
  return Math.min(to_s, from_s + (frame * speed) / frames_per_s);
}

/** Returns the bits per second that keep the picture sharp; larger pictures need fewer for each pixel. */
export function bitsPerSecond({ width, height }: Size, frames_per_s: number): number {
  return Math.round(RATE.bits_per_s * ((width * height * frames_per_s) / RATE.pixels_per_s) ** RATE.exponent);
}

/** Returns the longest film of a size, s. */
export function longestOf(size: Size, frames_per_s: number): number {
  return Math.floor((8 * LARGEST_BYTES) / bitsPerSecond(size, frames_per_s));
}
