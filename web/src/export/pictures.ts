import { styleOf } from "../plots/chart";
import type { Plot } from "../plots/plot";
import { scaleOf } from "../plots/sheet";

/** Size of the text on a picture, in pixels of the page. */
const TEXT = { title: 17, small: 13, margin: 14, line: 20 };
/** Height reserved for the text below, pixels of the page; unused height is cut off. */
const MOST_WORDS_PX = 160;

/** A picture on the page's background colour, with a title above it and text below. */
class Sheet {
  readonly canvas = document.createElement("canvas");
  private readonly pen: CanvasRenderingContext2D;
  private readonly style = styleOf();
  private y = TEXT.margin;

  /** Sizes are in pixels of the page; `scale` is the number of pixels of the picture per pixel of the page. */
  constructor(
    private readonly width: number,
    height: number,
    private readonly scale: number,
  ) {
    [this.canvas.width, this.canvas.height] = [Math.round(width * scale), Math.round(height * scale)];
    this.pen = this.canvas.getContext("2d")!;
    this.pen.scale(scale, scale);
    this.pen.fillStyle = this.style.colour("surface");
    this.pen.fillRect(0, 0, width, height);
    this.pen.textBaseline = "top";
  }

  private write(text: string, x: number, size: number, colour: string, weight = 400): number {
    this.pen.font = `${weight} ${size}px ${this.style.colour("font")}`;
    this.pen.fillStyle = this.style.colour(colour);
    this.pen.fillText(text, x, this.y, this.width - x - TEXT.margin);
    return this.pen.measureText(text).width;
  }

  title(text: string): void {
    this.write(text, TEXT.margin, TEXT.title, "ink", 700);
    this.y += TEXT.title + 8;
  }

  /** Draws the legend: lines with their colours and units, as many in a row as fit. */
  legend(entries: readonly { label: string; colour: string; unit: string }[]): void {
    let x = TEXT.margin;
    for (const { label, colour, unit } of entries) {
      const text = unit ? `${label}, ${unit}` : label;
      this.pen.font = `400 ${TEXT.small}px ${this.style.colour("font")}`;
      const width = this.pen.measureText(text).width + 40;
      if (x > TEXT.margin && x + width > this.width) [x, this.y] = [TEXT.margin, this.y + TEXT.line];
      this.pen.fillStyle = this.style.colour(colour);
      this.pen.fillRect(x, this.y + TEXT.small / 2 - 1, 18, 4);
      this.write(text, x + 24, TEXT.small, "ink");
      x += width;
    }
    this.y += TEXT.line + 4;
  }

  picture(canvas: HTMLCanvasElement, width: number, height: number): void {
    this.pen.drawImage(canvas, 0, this.y, width, height);
    this.y += height + 6;
  }

  /** Draws text in as many rows as needed. */
  words(text: string): void {
    this.pen.font = `400 ${TEXT.small}px ${this.style.colour("font")}`;
    const rows = [""];
    for (const word of text.split(" ")) {
      const longer = `${rows[rows.length - 1]} ${word}`.trim();
      if (this.pen.measureText(longer).width > this.width - 2 * TEXT.margin) rows.push(word);
      else rows[rows.length - 1] = longer;
    }
    for (const row of rows) {
      this.write(row, TEXT.margin, TEXT.small, "muted");
      this.y += TEXT.line;
    }
  }

  /** Cuts the picture to the height of its content, and returns it as a PNG file. */
  blob(): Promise<Blob> {
    const { width } = this.canvas;
    const height = Math.min(this.canvas.height, Math.round((this.y + TEXT.margin / 2) * this.scale));
    const cut = document.createElement("canvas");
    [cut.width, cut.height] = [width, height];
    cut.getContext("2d")!.drawImage(this.canvas, 0, 0);
    return new Promise((resolve, reject) => cut.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the browser made no picture"))), "image/png"));
  }
}

/** Makes a picture of the 3D view, with the name of the run and its time below. */
export function pictureOfShip(canvas: HTMLCanvasElement, title: string, time: string): Promise<Blob> {
  const scale = canvas.width / canvas.clientWidth;
  const sheet = new Sheet(canvas.clientWidth, canvas.clientHeight + 2 * TEXT.margin + 2 * TEXT.line, scale);
  sheet.title(title);
  sheet.picture(canvas, canvas.clientWidth, canvas.clientHeight);
  sheet.words(time);
  return sheet.blob();
}

/** Makes a picture of a plot with its title, the units of its lines, the text below it and the name of the run. */
export async function pictureOfPlot(plot: Plot, run: string): Promise<Blob | null> {
  const found = await plot.picture();
  if (!found) return null;
  const { canvas, entries, notes, title } = found;
  const scale = scaleOf(canvas);
  const [width, height] = [canvas.width / scale, canvas.height / scale];
  const sheet = new Sheet(width + TEXT.margin, height + 2 * TEXT.margin + entries.length * TEXT.line + MOST_WORDS_PX, scale);
  sheet.title(title);
  if (entries.length > 0) sheet.legend(entries);
  sheet.picture(canvas, width, height);
  if (notes) sheet.words(notes);
  sheet.words(run);
  return sheet.blob();
}
