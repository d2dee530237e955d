use super::*;
use crate::math::Random;

const REGION: Crop = Crop { x0: 2, y0: 1, x1: 37, y1: 20 };
const SAMPLES: u32 = 9;

/// A sample of any size, infinite or none at all.
fn sample(area: Crop, pixel: u64, number: u32) -> Color {
    let mut random = Random::new(&[area.x0.into(), area.y0.into(), pixel, number.into()]);
    let mut channel = || match random.below(40) {
        0 => f32::INFINITY,
        1 => f32::NAN,
        2 => -0.0,
        3 => f32::from_bits(random.below(1 << 23)),
        power => random.next_f32() * 2f32.powi(3 * power as i32 - 60),
    };
    Color::new(channel(), channel(), channel())
}

fn values(piece: &Piece, as_sums: bool) -> Values {
    let of_pixel = |pixel| piece.samples.clone().map(move |n| sample(piece.area, pixel, n));
    let pixels = 0..piece.area.pixels();
    if as_sums {
        Values::Sums(pixels.map(|pixel| of_pixel(pixel).sum()).collect())
    } else {
        Values::Samples(pixels.flat_map(of_pixel).collect())
    }
}

fn part(piece: Piece) -> Part {
    let values = values(&piece, piece.samples.start == 0);
    Part { piece, values }
}

fn bits(film: &Film) -> Vec<[u32; 3]> {
    film.means(Color::ZERO).iter().map(|color| color.to_array().map(f32::to_bits)).collect()
}

fn whole() -> Film {
    let film = Film::new(REGION, SAMPLES);
    film.missing(SAMPLES).into_iter().for_each(|piece| film.take(part(piece)).unwrap());
    film
}

#[test]
fn the_picture_does_not_depend_on_the_cuts_or_their_order() {
    let expected = bits(&whole());
    for division in Division::ALL {
        for count in [1, 2, 5, 30] {
            let mut parts: Vec<_> = (1..=count)
                .flat_map(|number| Share { number, count }.pieces(division, REGION, SAMPLES))
                .map(part)
                .collect();
            let mut random = Random::new(&[u64::from(count)]);
            for _ in 0..4 {
                for last in (1..parts.len()).rev() {
                    parts.swap(last, random.below(last as u32 + 1) as usize);
                }
                let film = Film::new(REGION, SAMPLES);
                for part in &parts {
                    assert!(!film.coverage().is_complete());
                    film.take(part.clone()).unwrap();
                }
                assert!(film.coverage().is_complete());
                assert!(bits(&film) == expected, "{division:?} {count}");
            }
        }
    }
}

#[test]
fn a_film_goes_on_from_its_own_parts() {
    let film = Film::with_moments(REGION, SAMPLES);
    let mut left = film.missing(4);
    for Piece { area, samples } in left.drain(2..) {
        let piece = Piece { area, samples };
        film.take(Part { values: values(&piece, false), piece }).unwrap();
    }
    let (tiles, coverage) = (tiles_of(REGION), film.coverage());
    assert_eq!(coverage.pixels, REGION.pixels() - tiles[0].pixels() - tiles[1].pixels());
    assert_eq!((coverage.samples, film.noise()), (4 * coverage.pixels, None));
    let resumed = Film::with_moments(REGION, SAMPLES);
    film.parts().into_iter().for_each(|part| resumed.take(part).unwrap());
    assert_eq!(resumed.coverage(), coverage);
    for film in [&film, &resumed] {
        for piece in film.missing(SAMPLES) {
            film.take(Part { values: values(&piece, false), piece }).unwrap();
        }
    }
    assert!(bits(&resumed) == bits(&whole()));
    assert_eq!(resumed.noise(), film.noise());
    assert!(film.noise().unwrap() > 0.0);
}

#[test]
fn what_does_not_fit_is_refused_and_changes_nothing() {
    let film = Film::new(REGION, SAMPLES);
    let area = tiles_of(REGION)[3];
    let piece = |samples| Piece { area, samples };
    film.take(part(piece(4..6))).unwrap();
    for twice in [0..5, 5..7, 4..6, 3..8, 5..6] {
        assert!(matches!(film.take(part(piece(twice))), Err(FilmError::Twice { .. })));
    }
    film.take(part(piece(0..4))).unwrap();
    assert_eq!(film.missing(SAMPLES)[3].samples, 6..9);
    assert!(matches!(film.take(part(piece(5..7))), Err(FilmError::Twice { .. })));
    #[expect(clippy::reversed_empty_ranges, reason = "this is what is refused")]
    for range in [6..10, 7..7, 8..7] {
        let values = Values::Samples(Vec::new());
        let refused = film.take(Part { piece: piece(range), values });
        assert!(matches!(refused, Err(FilmError::Range { .. })));
    }
    let late = Part { values: values(&piece(6..9), true), piece: piece(6..9) };
    assert!(matches!(film.take(late), Err(FilmError::Range { .. })));
    let mut short = part(piece(6..9));
    let Values::Samples(samples) = &mut short.values else { panic!("it begins late") };
    samples.pop();
    assert!(matches!(film.take(short), Err(FilmError::Length { .. })));
    let moved = Piece { area: Crop { x0: area.x0 + 1, ..area }, samples: 6..9 };
    assert!(matches!(film.take(part(moved)), Err(FilmError::NoTile { .. })));
    film.take(part(piece(6..9))).unwrap();
    let silent = Film::with_moments(REGION, SAMPLES);
    assert!(matches!(silent.take(part(piece(0..1))), Err(FilmError::NoMoments { .. })));
}
